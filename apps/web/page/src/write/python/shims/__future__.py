# What Python 3 does anyway.
absolute_import = annotations = division = print_function = unicode_literals = None

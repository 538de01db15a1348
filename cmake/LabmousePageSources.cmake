# What the page asks for of `lab` and `external`: the sources of its WebAssembly module and of the fuzzer of its calls.
set(LABMOUSE_PAGE_SOURCES)
foreach(name IN ITEMS
    failure_rates/failure_file failure_rates/failure_odds failure_rates/failure_tally
    bench/distance_speed bench/plain_distance bench/signature bench/speed_json bounds/bounds bounds/drive_bound bounds/mms_bound live/live_line live/live_map live/live_plan live/live_reader
    mazes/maze_files mazes/maze_link mice/contestant mice/mice_json mice/mouse_names mice/prior_file mice/prior_learning mice/specs
    numbers/maze_interval numbers/sign_flips numbers/statistics numbers/student numbers/verdict numbers/wealth_process numbers/wilson pictures/drive_path pictures/path_data pictures/drive_picture pictures/trace_path pictures/mms_picture pictures/picture_layers
    races/never_started races/race races/race_paths races/value races/value_json races/world_setting records/drive_json records/drive_notation
    records/drive_record_fields records/drive_record_reader records/drive_record_replay records/drive_record_text
    records/drive_record_writer records/drive_route_check records/drive_story records/explanation records/mms_record
    records/mms_record_reader records/mms_record_replay records/packed_record records/physical_lines records/physical_replay records/record_maze records/record_parts
    records/record_reader records/record_reasons records/record_replay records/record_writer robots/drive_rules_file
    robots/hardware_keys robots/robot_data robots/robot_family robots/robot_file robots/robot_files robots/robot_json robots/robot_keys robots/robot_remarks robots/robot_table
    robots/robot_text routes/region_picture routes/region_table routes/route_data
    routes/route_regions routes/route_report routes/varied_number standings/common_fields
    standings/maze_scores standings/mouse_figures standings/mouse_pair standings/race_json standings/race_notes standings/standings studies/compare studies/compare_report studies/sequential_test system/file_names
    system/named_text system/streams system/version text/encoding text/errors_text text/json text/json_lines text/json_problem text/json_stream text/last_lines text/markup
    text/number_rows text/numbers
    text/printable text/toml_text)
  list(APPEND LABMOUSE_PAGE_SOURCES ${PROJECT_SOURCE_DIR}/labmouse/lab/${name}.cpp)
endforeach()
foreach(name IN ITEMS dialogue mms/canvas mms/command mms/host mms/outcome mms/statistics protocol quoted_line verdict)
  list(APPEND LABMOUSE_PAGE_SOURCES ${PROJECT_SOURCE_DIR}/labmouse/external/${name}.cpp)
endforeach()
foreach(package IN ITEMS drawing steps drive mms worlds replays page)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/labmouse/lab/${package}/*.cpp)
  if(NOT sources)
    message(FATAL_ERROR "labmouse/lab/${package} has no sources")
  endif()
  # What only terminals and files show, and what is read from files alone.
  list(FILTER sources EXCLUDE REGEX "/(draw_text|draw_plot|world_table)[.]cpp$")
  list(APPEND LABMOUSE_PAGE_SOURCES ${sources})
endforeach()

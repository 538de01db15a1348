#include "embedded_page.hpp"

// The assembler includes the file directly, because a string literal of that size takes minutes to compile.
// LABMOUSE_PAGE_COPY is its path: see cmake/LabmousePage.cmake.
__asm__(
    ".section .rodata\n"
    "labmouse_page_begin:\n"
    ".incbin \"" LABMOUSE_PAGE_COPY
    "\"\n"
    "labmouse_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" {
extern const char labmouse_page_begin[];
extern const char labmouse_page_end[];
}

namespace labmouse::cli {

std::string_view embedded_page() {
  return {labmouse_page_begin, static_cast<std::size_t>(labmouse_page_end - labmouse_page_begin)};
}

}  // namespace labmouse::cli

/* The lines of one robot by templates/labmouse_stream.h, compiled as C99 and as C++11. */
#ifndef STREAM_IN_C_H
#define STREAM_IN_C_H
#ifdef __cplusplus
extern "C" {
#endif
void stream_in_c(void (*put)(char letter));
void stream_in_cpp11(void (*put)(char letter));
#ifdef __cplusplus
}
#endif
#endif

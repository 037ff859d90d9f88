// SPDX-License-Identifier: Apache-2.0
// The border between the program and the module that holds OpenImageIO: plain C functions found by name, so that either
// side can be built without the other. Nothing throws across it.
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Raised with every change of what is below; the loader refuses another number.
enum { AUSLAN_OIIO_ABI = 2 };

/// What a call came to. On anything but kOk `error` holds a sentence (cut to `error_size`).
enum auslan_oiio_status {
  AUSLAN_OIIO_OK = 0,
  AUSLAN_OIIO_MALFORMED = 1,
  AUSLAN_OIIO_LIMIT = 2,
  AUSLAN_OIIO_FAILED = 3
};

/// Takes the bytes of an encoded file. Returns 0, or anything else to stop.
typedef int (*auslan_oiio_take)(void* user, const uint8_t* bytes, size_t size);

/// A GIF that is being made in memory.
typedef struct auslan_oiio_gif auslan_oiio_gif;

typedef int (*auslan_oiio_abi_fn)(void);
/// Encodes width * height pixels 0x00RRGGBB as an 8-bit RGB PNG without metadata.
typedef int (*auslan_oiio_encode_png_fn)(const uint32_t* pixels, int width, int height, auslan_oiio_take take,
                                         void* user, char* error, size_t error_size);
/// Reads a PNG from memory. `pixels` is called once with the size and returns where width * height pixels go, or null.
typedef uint32_t* (*auslan_oiio_place)(void* user, int width, int height);
typedef int (*auslan_oiio_decode_fn)(const uint8_t* bytes, size_t size, const char* format, int subimage, int max_side,
                                     auslan_oiio_place place, void* user, char* error, size_t error_size);
/// Reads a picture of any maker ("png", "jpeg") of at most `max_pixels` as 0xAARRGGBB, colours not multiplied by alpha.
typedef int (*auslan_oiio_decode_image_fn)(const uint8_t* bytes, size_t size, const char* format, size_t max_pixels,
                                           auslan_oiio_place place, void* user, char* error, size_t error_size);
/// Null on failure.
typedef auslan_oiio_gif* (*auslan_oiio_gif_open_fn)(int width, int height, double fps, char* error, size_t error_size);
/// Appends a frame, and hands out the bytes that are complete so far.
typedef int (*auslan_oiio_gif_write_fn)(auslan_oiio_gif* gif, const uint32_t* pixels, auslan_oiio_take take, void* user,
                                        char* error, size_t error_size);
/// Hands out the rest. The object must still be closed.
typedef int (*auslan_oiio_gif_finish_fn)(auslan_oiio_gif* gif, auslan_oiio_take take, void* user, char* error,
                                         size_t error_size);
typedef void (*auslan_oiio_gif_close_fn)(auslan_oiio_gif* gif);

#ifdef __cplusplus
}
#endif

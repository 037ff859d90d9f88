// SPDX-License-Identifier: Apache-2.0
// The only source of the project that sees OpenImageIO.
#include "oiio_abi.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#define AUSLAN_EXPORT extern "C" __attribute__((visibility("default")))

namespace {

void say(char* error, size_t size, const std::string& message) {
  if (size > 0) std::snprintf(error, size, "%s", message.c_str());
}

OIIO::ImageSpec rgb_spec(int width, int height) {
  return {width, height, 3, OIIO::TypeDesc::UINT8};
}

void to_rgb(const uint32_t* pixels, size_t count, std::vector<uint8_t>& rgb) {
  rgb.resize(3 * count);
  for (size_t i = 0; i < count; ++i) {
    rgb[3 * i] = static_cast<uint8_t>(pixels[i] >> 16);
    rgb[3 * i + 1] = static_cast<uint8_t>(pixels[i] >> 8);
    rgb[3 * i + 2] = static_cast<uint8_t>(pixels[i]);
  }
}

size_t area(int width, int height) {
  return static_cast<size_t>(width) * static_cast<size_t>(height);
}

/// Runs `body`, which returns a status, and turns what is thrown into one.
template <typename Body>
int guarded(char* error, size_t error_size, Body body) {
  try {
    return body();
  } catch (const std::exception& thrown) {
    say(error, error_size, thrown.what());
  } catch (...) {
    say(error, error_size, "unknown failure");
  }
  return AUSLAN_OIIO_FAILED;
}

int failed(char* error, size_t error_size, const std::string& message, int status = AUSLAN_OIIO_FAILED) {
  say(error, error_size, message);
  return status;
}

/// Opens a picture in memory. `reader` outlives what comes out.
int open_input(OIIO::Filesystem::IOMemReader& reader, const char* format, std::unique_ptr<OIIO::ImageInput>& input,
               char* error, size_t error_size) {
  input = OIIO::ImageInput::create(format, false, nullptr, &reader);
  if (!input) return failed(error, error_size, OIIO::geterror());
  // create() only chooses the format with the reader's help: it has to be handed over again to be read from.
  if (!input->set_ioproxy(&reader)) return failed(error, error_size, "this format is not read from memory");
  OIIO::ImageSpec spec, wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1);
  if (!input->open(std::string("picture.") + format, spec, wanted))
    return failed(error, error_size, input->geterror(), AUSLAN_OIIO_MALFORMED);
  return AUSLAN_OIIO_OK;
}

int decode_image(const uint8_t* bytes, size_t size, const char* format, size_t max_pixels, auslan_oiio_place place,
                 void* user, char* error, size_t error_size) {
  OIIO::Filesystem::IOMemReader reader(const_cast<uint8_t*>(bytes), size);
  std::unique_ptr<OIIO::ImageInput> input;
  if (const int status = open_input(reader, format, input, error, error_size); status != AUSLAN_OIIO_OK) return status;
  const OIIO::ImageSpec spec = input->spec();
  const int channels = spec.nchannels;
  if (spec.width < 1 || spec.height < 1 || channels < 1 || channels > 4)
    return failed(error, error_size, "it has no pixels or strange channels", AUSLAN_OIIO_MALFORMED);
  if (area(spec.width, spec.height) > max_pixels)
    return failed(error, error_size, "it is larger than " + std::to_string(max_pixels) + " pixels", AUSLAN_OIIO_LIMIT);
  const size_t count = area(spec.width, spec.height);
  std::vector<uint8_t> samples(count * static_cast<size_t>(channels));
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, samples.data()))
    return failed(error, error_size, input->geterror(), AUSLAN_OIIO_MALFORMED);
  uint32_t* pixels = place(user, spec.width, spec.height);
  if (pixels == nullptr) return failed(error, error_size, "no room for its pixels", AUSLAN_OIIO_LIMIT);
  const bool grey = channels < 3;
  const bool has_alpha = channels == 2 || channels == 4;
  for (size_t i = 0; i < count; ++i) {
    const uint8_t* pixel = samples.data() + i * static_cast<size_t>(channels);
    const uint32_t alpha = has_alpha ? pixel[channels - 1] : 255U;
    pixels[i] = alpha << 24 | uint32_t{pixel[0]} << 16 | uint32_t{pixel[grey ? 0 : 1]} << 8 | pixel[grey ? 0 : 2];
  }
  return AUSLAN_OIIO_OK;
}

int decode(const uint8_t* bytes, size_t size, const char* format, int subimage, int max_side, auslan_oiio_place place,
           void* user, char* error, size_t error_size) {
  OIIO::Filesystem::IOMemReader reader(const_cast<uint8_t*>(bytes), size);
  std::unique_ptr<OIIO::ImageInput> input;
  if (const int status = open_input(reader, format, input, error, error_size); status != AUSLAN_OIIO_OK) return status;
  OIIO::ImageSpec spec;
  if (subimage > 0 && !input->seek_subimage(subimage, 0))
    return failed(error, error_size, "there is no such frame", AUSLAN_OIIO_MALFORMED);
  spec = input->spec();
  const int channels = spec.nchannels;
  if (spec.width < 1 || spec.height < 1 || channels < 1 || channels > 4)
    return failed(error, error_size, "it has no pixels or strange channels", AUSLAN_OIIO_MALFORMED);
  if (spec.width > max_side || spec.height > max_side)
    return failed(error, error_size, "it is larger than " + std::to_string(max_side) + " pixels a side",
                  AUSLAN_OIIO_LIMIT);
  const size_t count = area(spec.width, spec.height);
  std::vector<uint8_t> samples(count * static_cast<size_t>(channels));
  if (!input->read_image(subimage, 0, 0, channels, OIIO::TypeDesc::UINT8, samples.data()))
    return failed(error, error_size, input->geterror(), AUSLAN_OIIO_MALFORMED);
  const bool grey = channels < 3;
  const bool has_alpha = channels == 2 || channels == 4;
  const auto sample = [&](size_t pixel, int channel) {
    return uint32_t{samples[pixel * static_cast<size_t>(channels) + static_cast<size_t>(channel)]};
  };
  if (has_alpha)
    for (size_t i = 0; i < count; ++i)
      if (sample(i, channels - 1) != 255)
        return failed(error, error_size, "it is transparent in places", AUSLAN_OIIO_MALFORMED);
  uint32_t* pixels = place(user, spec.width, spec.height);
  if (pixels == nullptr) return failed(error, error_size, "no room for its pixels", AUSLAN_OIIO_LIMIT);
  for (size_t i = 0; i < count; ++i)
    pixels[i] = sample(i, 0) << 16 | sample(i, grey ? 0 : 1) << 8 | sample(i, grey ? 0 : 2);
  return AUSLAN_OIIO_OK;
}

}  // namespace

/// The writer keeps a pointer to the buffer: it must be destroyed first, so it stands last.
struct auslan_oiio_gif {
  std::vector<unsigned char> buffer;
  OIIO::Filesystem::IOVecOutput proxy{buffer};
  OIIO::ImageSpec spec;
  std::vector<uint8_t> rgb;
  size_t handed_out = 0;
  bool started = false;
  std::unique_ptr<OIIO::ImageOutput> output;
};

namespace {

int hand_out(auslan_oiio_gif* gif, auslan_oiio_take take, void* user, char* error, size_t error_size) {
  const size_t ready = gif->buffer.size() - gif->handed_out;
  if (ready > 0 && take(user, gif->buffer.data() + gif->handed_out, ready) != 0)
    return failed(error, error_size, "the bytes could not be taken");
  gif->handed_out = gif->buffer.size();
  return AUSLAN_OIIO_OK;
}

}  // namespace

AUSLAN_EXPORT int auslan_oiio_abi() {
  return AUSLAN_OIIO_ABI;
}

AUSLAN_EXPORT int auslan_oiio_encode_png(const uint32_t* pixels, int width, int height, auslan_oiio_take take,
                                         void* user, char* error, size_t error_size) {
  return guarded(error, error_size, [&]() -> int {
    std::vector<unsigned char> buffer;
    OIIO::Filesystem::IOVecOutput proxy(buffer);
    const auto output = OIIO::ImageOutput::create("png", &proxy);
    if (!output) return failed(error, error_size, OIIO::geterror());
    std::vector<uint8_t> rgb;
    to_rgb(pixels, area(width, height), rgb);
    // No Software, no DateTime; the values are sRGB already.
    OIIO::ImageSpec spec = rgb_spec(width, height);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (!output->open("picture.png", spec) || !output->write_image(OIIO::TypeDesc::UINT8, rgb.data()) ||
        !output->close())
      return failed(error, error_size, output->geterror());
    if (take(user, buffer.data(), buffer.size()) != 0) return failed(error, error_size, "the bytes could not be taken");
    return AUSLAN_OIIO_OK;
  });
}

AUSLAN_EXPORT int auslan_oiio_decode_image(const uint8_t* bytes, size_t size, const char* format, size_t max_pixels,
                                           auslan_oiio_place place, void* user, char* error, size_t error_size) {
  return guarded(error, error_size, [&]() -> int {
    return decode_image(bytes, size, format, max_pixels, place, user, error, error_size);
  });
}

AUSLAN_EXPORT int auslan_oiio_decode(const uint8_t* bytes, size_t size, const char* format, int subimage, int max_side,
                                     auslan_oiio_place place, void* user, char* error, size_t error_size) {
  return guarded(error, error_size, [&]() -> int {
    return decode(bytes, size, format, subimage, max_side, place, user, error, error_size);
  });
}

AUSLAN_EXPORT auslan_oiio_gif* auslan_oiio_gif_open(int width, int height, double fps, char* error, size_t error_size) {
  auslan_oiio_gif* made = nullptr;
  guarded(error, error_size, [&]() -> int {
    auto gif = std::make_unique<auslan_oiio_gif>();
    gif->output = OIIO::ImageOutput::create("gif", &gif->proxy);
    if (!gif->output) return failed(error, error_size, OIIO::geterror());
    gif->spec = rgb_spec(width, height);
    gif->spec.attribute("oiio:Movie", 1);
    gif->spec.attribute("gif:Interlacing", 0);
    gif->spec.attribute("FramesPerSecond", static_cast<float>(fps));
    gif->spec.attribute("gif:FPS", static_cast<float>(fps));
    made = gif.release();
    return AUSLAN_OIIO_OK;
  });
  return made;
}

AUSLAN_EXPORT int auslan_oiio_gif_write(auslan_oiio_gif* gif, const uint32_t* pixels, auslan_oiio_take take, void* user,
                                        char* error, size_t error_size) {
  return guarded(error, error_size, [&]() -> int {
    to_rgb(pixels, area(gif->spec.width, gif->spec.height), gif->rgb);
    const auto mode = gif->started ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create;
    if (!gif->output->open("picture.gif", gif->spec, mode) ||
        !gif->output->write_image(OIIO::TypeDesc::UINT8, gif->rgb.data()))
      return failed(error, error_size, gif->output->geterror());
    gif->started = true;
    return hand_out(gif, take, user, error, error_size);
  });
}

AUSLAN_EXPORT int auslan_oiio_gif_finish(auslan_oiio_gif* gif, auslan_oiio_take take, void* user, char* error,
                                         size_t error_size) {
  return guarded(error, error_size, [&]() -> int {
    if (!gif->output->close()) return failed(error, error_size, gif->output->geterror());
    return hand_out(gif, take, user, error, error_size);
  });
}

AUSLAN_EXPORT void auslan_oiio_gif_close(auslan_oiio_gif* gif) {
  delete gif;
}

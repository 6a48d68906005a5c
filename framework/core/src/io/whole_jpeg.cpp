// SPDX-License-Identifier: Apache-2.0
// JPEG: libjpeg decodes the coefficients and tells what it had to make up.
#include <csetjmp>
#include <cstdio>
#include <string>

#include <jpeglib.h>
// After jpeglib.h, which it needs.
#include <jerror.h>

#include "io/possible_size.hpp"
#include "io/whole_file.hpp"
#include "xgm/base/error.hpp"
#include "xgm/io/file.hpp"

namespace xgm {
namespace {

/// libjpeg's error handler, which it calls with the first member.
struct Fault {
  jpeg_error_mgr handler;
  std::jmp_buf stop;
  char text[JMSG_LENGTH_MAX];
};

Fault& fault_of(j_common_ptr jpeg) { return *reinterpret_cast<Fault*>(jpeg->err); }

/// Of the warnings, these do not concern the pixels.
bool is_harmless(int code) { return code == JWRN_JFIF_MAJOR || code == JWRN_ADOBE_XFORM; }

[[noreturn]] void stop(j_common_ptr jpeg) {
  Fault& fault = fault_of(jpeg);
  fault.handler.format_message(jpeg, fault.text);
  std::longjmp(fault.stop, 1);
}

void stop_at_warning(j_common_ptr jpeg, int level) {
  constexpr int kWarning = -1;
  if (level == kWarning && !is_harmless(jpeg->err->msg_code)) stop(jpeg);
}

/// Those that libjpeg takes memory for: whole blocks, as many as its sampling factors ask for.
std::uint64_t coefficients(const jpeg_decompress_struct& jpeg) {
  const auto rounded = [](JDIMENSION blocks, int step) {
    const auto unit = static_cast<std::uint64_t>(step);
    return (blocks + unit - 1) / unit * unit;
  };
  std::uint64_t blocks = 0;
  for (int i = 0; i < jpeg.num_components; ++i) {
    const jpeg_component_info& part = jpeg.comp_info[i];
    blocks += rounded(part.width_in_blocks, part.h_samp_factor) *
              rounded(part.height_in_blocks, part.v_samp_factor);
  }
  return blocks * DCTSIZE2;
}

/// What is wrong with the data, in libjpeg's words; empty if nothing is. Holds no object with a
/// destructor, as libjpeg leaves it by longjmp.
void look_for_fault(const std::string& bytes, Fault& fault) {
  jpeg_decompress_struct jpeg{};
  jpeg.err = jpeg_std_error(&fault.handler);
  fault.handler.error_exit = stop;
  fault.handler.emit_message = stop_at_warning;
  if (setjmp(fault.stop) == 0) {
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&jpeg, TRUE);
    if (is_possible_size(bytes.size(), coefficients(jpeg) * sizeof(JCOEF))) {
      jpeg_read_coefficients(&jpeg);
      jpeg_finish_decompress(&jpeg);
    } else {
      std::snprintf(fault.text, sizeof fault.text, "it states %u x %u pixels", jpeg.image_width,
                    jpeg.image_height);
    }
  }
  jpeg_destroy_decompress(&jpeg);
}

}  // namespace

void require_whole_jpeg(const std::string& file) {
  Fault fault{};
  look_for_fault(read_file(file), fault);
  if (fault.text[0] == '\0') return;
  throw Error(file + ": is cut short or damaged (" + std::string(fault.text) +
              "); give a complete JPEG");
}

}  // namespace xgm

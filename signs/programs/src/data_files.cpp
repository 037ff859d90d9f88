// SPDX-License-Identifier: Apache-2.0
#include "data_files.h"

#include <cstdlib>
#include <system_error>

namespace auslan {

std::filesystem::path data_file(std::string_view name) {
  namespace fs = std::filesystem;
  if (const char* folder = std::getenv("AUSLANJAM_DATA"); folder != nullptr && *folder != '\0')
    return fs::path(folder) / name;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  return program.parent_path().parent_path() / "share" / "auslanjam" / name;
}

}  // namespace auslan

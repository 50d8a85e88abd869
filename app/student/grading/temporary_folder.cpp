// SPDX-License-Identifier: MIT
#include "app/student/grading/temporary_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_folder.h"

namespace shadowlab::student {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
    std::error_code failed;
    std::string name = (fs::temp_directory_path(failed) / "shadowlab-grade-XXXXXX").string();
    if (failed || !::mkdtemp(name.data()))
        throw Error(ExitStatus::cannotWrite,
                    name + ": " + std::strerror(errno) + "; name another folder for temporary files with TMPDIR");
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::folder(const std::string& name) const {
    fs::path folder = path_ / name;
    image::makeFolders(folder);
    return folder;
}

} // namespace shadowlab::student

// The messages for failed writes. The messages of the system are not used, because they depend on the locale and name no
// remedy.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/output_error.h"

#include <cerrno>
#include <system_error>

namespace shadowlab::image {
namespace {

struct Reason {
    std::string what, remedy;
};

Reason missingFolder(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path();
    std::error_code ignored;
    if (folder.empty() || std::filesystem::exists(folder, ignored))
        return {"no such file or folder", "choose another name"}; // a dangling link, a device without a driver
    return {"the folder " + folder.string() + " does not exist", "make it with mkdir -p " + folder.string()};
}

Reason reasonFor(const std::filesystem::path& path, int errorNumber) {
    switch (errorNumber) {
    case ENOSPC: return {"no space left on device", "free some space"};
    case EDQUOT: return {"disk quota exceeded", "free some space"};
    case EFBIG: return {"file too large", "raise the file size limit (ulimit -f)"};
    case ENOENT: return missingFolder(path);
    case ENOTDIR: return {"a part of the path is a file and not a folder", "choose another name"};
    case EEXIST:
    case ENOTEMPTY: return {"there is something of that name already", "choose another name"};
    case EISDIR: return {"is a folder", "add a file name to it"};
    case EACCES:
    case EPERM: return {"permission denied", "choose a folder that you may write to"};
    case EROFS: return {"read-only file system", "choose a folder that you may write to"};
    case ENAMETOOLONG: return {"file name too long", "choose one of at most 255 bytes"};
    case ELOOP: return {"symbolic links go in a circle", "choose another name"};
    case EPIPE: return {"the reader has closed the pipe", "let it read to the end"};
    case ENXIO: return {"no such device, or nobody reads the pipe", "start its reader first, or choose another name"};
    case EBADF: return {"is not open for writing", "choose another name"};
    case EMFILE:
    case ENFILE: return {"too many open files", "raise the limit (ulimit -n)"};
    case EIO: return {"input/output error", "check the disk"};
    default: return {std::generic_category().message(errorNumber), "choose another place"};
    }
}

} // namespace

std::string outputErrorText(const std::filesystem::path& path, int errorNumber, bool oldFileKept) {
    const Reason reason = reasonFor(path, errorNumber);
    return path.string() + ": " + reason.what + "; " + reason.remedy + (oldFileKept ? " (the old file is kept)" : "");
}

} // namespace shadowlab::image

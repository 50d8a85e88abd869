// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_files.h"

#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/gltf/gltf_container.h"
#include "techniques/foundation/scene/gltf/gltf_uris.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

GltfFiles::Found GltfFiles::find(const JsonDocument& document, const JsonValue& value) {
    const std::string& uri = value.string;
    if (hasScheme(uri)) return {std::nullopt, "is an address; only files beside this one are read: save it there"};
    if (!folders_) {
        folders_.emplace(file_, options_);
        misnamed_.emplace(*folders_);
    }
    std::string reference = percentDecoded(uri);
    if (!misnamed_->isThere(reference) && misnamed_->isThere(uri)) reference = uri; // a name that holds %
    if (!misnamed_->isThere(reference))
        if (const auto found = misnamed_->find(reference)) {
            misnamedNote_.add(document.place(value.offset), uri, *found);
            reference = *found;
        }
    const auto canonical = folders_->resolve(reference);
    if (!canonical) return {std::nullopt, std::string(kOutsideMessage)};
    if (const std::string fault = whyUnreadable(*canonical); !fault.empty())
        return {std::nullopt, fault + misnamed_->severalAlike() + "; put the file beside this one"};
    return {*canonical};
}

GltfBuffers::GltfBuffers(GltfSource& source, const GltfContainer& container, GltfFiles& files, const LoadOptions& options) {
    const std::vector<JsonValue>& buffers = source.elements("buffers");
    double total = 0;
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const double length = gltfMember(buffers[i], "byteLength")->number;
        const auto refuse = [&](const std::string& why, ExitStatus status = ExitStatus::badInput) {
            source.fail("buffers", i, why, status);
        };
        total += length;
        if (total > static_cast<double>(options.limits.fileBytes))
            refuse("brings the buffers to " + numberText(total) + " bytes, more than the limit of " +
                       std::to_string(options.limits.fileBytes) + "; simplify the model, or set --limit mesh-file=VALUE",
                   ExitStatus::overLimit);
        const JsonValue* uri = gltfMember(buffers[i], "uri");
        std::string_view bytes;
        if (!uri) {
            if (i > 0 || !container.hasBinary)
                refuse(i > 0 ? "has no uri; only the first buffer of a .glb may have its bytes in the file itself"
                             : "has no uri, and the file has no binary chunk; give the buffer its file, or export the model as .glb");
            bytes = container.binary();
        } else if (isDataUri(uri->string)) {
            auto decoded = bytesOfDataUri(uri->string);
            if (!decoded) refuse("has a data: URI that is not well-formed base64; export the model again");
            bytes = *owned_.emplace_back(std::make_unique<std::string>(std::move(*decoded)));
        } else {
            const GltfFiles::Found found = files.find(source.document(), *uri);
            if (!found.canonical) refuse("names " + inQuotes(uri->string) + ", which " + found.fault);
            std::unique_ptr<std::string>& text = files_[*found.canonical];
            if (!text) {
                text = std::make_unique<std::string>(readFile(*found.canonical, options.limits.fileBytes, "mesh-file"));
                image::keepInput(*found.canonical);
            }
            bytes = *text;
        }
        if (static_cast<double>(bytes.size()) < length)
            refuse("is said to have " + numberText(length) + " bytes, but only " + std::to_string(bytes.size()) +
                   " are there: the file was cut off; export the model again");
        bytes_.push_back(bytes.substr(0, static_cast<std::size_t>(length)));
    }
}

} // namespace shadowlab::scene

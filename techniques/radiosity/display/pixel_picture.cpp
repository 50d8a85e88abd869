// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/pixel_picture.h"

#include "techniques/foundation/gl/scene/surfaces.h"

namespace shadowlab::radiosity {

namespace {

/// Pixels on a side of the blocks that are asked for first: a sixteenth of the rays, which in every built-in scene 1280x720 are there after less than 0.1 s.
constexpr int kFirstBlockSide = 4;

gl::Texture2D uploaded(GLenum internalFormat, GLenum format, ivec2 size, const void* texels, std::string_view name) {
    gl::Texture2D texture(internalFormat, size, name);
    texture.bind(0);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, format, GL_FLOAT, texels);
    return texture;
}

} // namespace

bool PixelPicture::advanceDirect(const scene::Snapshot& snapshot, const View& view, Deadline deadline) {
    View ofBlocks = view;
    ofBlocks.size = (view.size + kFirstBlockSide - 1) / kFirstBlockSide;
    hasNewBlocks_ = false;
    if (deadline != Deadline::max()) { // in a hurry
        if (!blocks_.advancePreview(snapshot, ofBlocks, deadline)) return false;
        hasNewBlocks_ = blocks_.version() != blocksVersion_;
        blocksVersion_ = blocks_.version();
        if (hasNewBlocks_) {
            uploadDirect(blocks_);
            return false;
        }
    }
    const bool isComplete = direct_.advance(snapshot, view, deadline);
    uploadDirect(direct_.hasPreview() ? direct_ : blocks_);
    return isComplete;
}

void PixelPicture::uploadDirect(const PixelLight& shown) {
    static_assert(sizeof(PixelLight::Share) == 2 * sizeof(float));
    const bool ofBlocks = &shown == &blocks_;
    shares_.resize(shown.lights());
    for (int light = 0; light < static_cast<int>(shares_.size()); ++light)
        if (UploadedShares& shares = shares_[static_cast<std::size_t>(light)]; shares.version != shown.version(light) || shares.ofBlocks != ofBlocks) {
            shares = {shown.version(light), ofBlocks, ofBlocks || shown.isPreview(light),
                      uploaded(GL_RG32F, GL_RG, shown.size(), shown.sharesFromBelow(light).data(), "radiosity: direct light of pixels")};
            ++version_;
        }
}

bool PixelPicture::advanceGather(const GatherSolution& solution, std::size_t rays, Deadline deadline) {
    const bool isComplete = gather_.advance(solution, direct_, rays, deadline);
    hasGathered_ = gather_.hasPicture();
    if (const GatheredVersion version{false, gather_.version()}; hasGathered_ && version != gathered_) {
        upload(gather_.irradianceFromBelow());
        gathered_ = version;
    }
    return isComplete;
}

bool PixelPicture::advanceSharedGather(const GatherSolution& solution, std::size_t rays, Deadline deadline) {
    hasGathered_ = shared_.advance(solution, direct_, rays, deadline);
    if (const GatheredVersion version{true, shared_.version()}; hasGathered_ && version != gathered_) {
        upload(shared_.irradianceFromBelow());
        gathered_ = version;
    }
    return hasGathered_;
}

void PixelPicture::upload(const std::vector<vec4>& irradianceFromBelow) {
    ++version_;
    irradiance_ = uploaded(GL_RGBA32F, GL_RGBA, direct_.size(), irradianceFromBelow.data(), "radiosity: gathered light");
}

void PixelPicture::useForLight(const Frame& frame, const gl::Program& program, int light) const {
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    const gl::Texture2D& shares = shares_[static_cast<std::size_t>(light)].texture;
    shares.bind(gl::kFirstFreeUnit);
    program.set("shares", gl::kFirstFreeUnit);
    program.set("sharesPerPixel", vec2(shares.size()) / vec2(frame.view().size));
}

void PixelPicture::addDirect(const Frame& frame, int light, double exposureFactor) const {
    gl::setAddLightState();
    useForLight(frame, reflected_, light);
    const scene::Light& source = frame.scene().light(light);
    const bool byArea = scene::hasArea(source) && !shares_[static_cast<std::size_t>(light)].isPreview;
    reflected_.set("areaRadiance", byArea ? static_cast<float>(source.intensity) * source.color : vec3(0.0f));
    reflected_.set("exposureFactor", static_cast<float>(exposureFactor));
    gl::drawSurfaces(reflected_, frame.scene(), frame.buffers(), frame.eye());
}

void PixelPicture::drawGathered(const Frame& frame, double exposureFactor) const {
    gl::setVisibilityState();
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::useForMaterials(gatheredLight_, frame.scene(), frame.buffers());
    irradiance_.bind(gl::kFirstFreeUnit);
    gatheredLight_.set("irradiance", gl::kFirstFreeUnit);
    gatheredLight_.set("exposureFactor", static_cast<float>(exposureFactor));
    gl::drawSurfaces(gatheredLight_, frame.scene(), frame.buffers(), frame.eye());
}

void PixelPicture::drawVisibility(const Frame& frame, int light) const {
    gl::setVisibilityState();
    useForLight(frame, visibility_, light);
    gl::drawSurfaces(visibility_, frame.scene(), frame.buffers(), frame.eye());
}

} // namespace shadowlab::radiosity

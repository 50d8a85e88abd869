// What each pixel finds out for itself, drawn: direct light, and what it has gathered of the light that patches send.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/gl/program.h"
#include "techniques/foundation/gl/texture.h"
#include "techniques/frame.h"
#include "techniques/radiosity/display/pixel_gather.h"
#include "techniques/radiosity/display/shared_gather.h"
#include "techniques/radiosity/lights/pixel_light.h"

namespace shadowlab::radiosity {

class PixelPicture {
public:
    /// Finds the direct light. True when it is complete. In a hurry blocks of 4 x 4 pixels ask first, together; once they have answers it returns, so
    /// that these are shown before anything else is asked.
    bool advanceDirect(const scene::Snapshot& snapshot, const View& view, Deadline deadline);
    /// Can direct light be shown? Before it is complete, that of lights with an area comes from their centres, and at first that of all
    /// lights in blocks of pixels.
    [[nodiscard]] bool hasDirect() const { return direct_.hasPreview() || blocks_.hasPreview(); }
    /// Did the last call return because of that?
    [[nodiscard]] bool hasNewBlocks() const { return hasNewBlocks_; }
    /// Gathers for each pixel, once direct light is complete. True when each has sent so many rays.
    bool advanceGather(const GatherSolution& solution, std::size_t rays, Deadline deadline);
    /// Gathers for some pixels, and shares. True when all have their irradiance.
    bool advanceSharedGather(const GatherSolution& solution, std::size_t rays, Deadline deadline);
    /// Of the shared gather: how many pixels have gathered.
    [[nodiscard]] std::size_t gathered() const { return shared_.gathered(); }
    /// Can what was gathered last be shown?
    [[nodiscard]] bool hasGathered() const { return hasGathered_; }
    /// Changes whenever there is something else to be shown.
    [[nodiscard]] std::uint64_t version() const { return version_; }

    // All draw into the bound framebuffer, on the surfaces in its depth buffer, and clear the stencil.

    /// Adds the radiance toward the eye that a light's direct light is reflected as.
    void addDirect(const Frame& frame, int light, double exposureFactor) const;
    /// Draws what the surfaces emit, and what they reflect of what was gathered.
    void drawGathered(const Frame& frame, double exposureFactor) const;
    /// Red: the share of the light that is seen; green: 1 where there is a surface.
    void drawVisibility(const Frame& frame, int light) const;

private:
    void uploadDirect(const PixelLight& shown);
    void upload(const std::vector<vec4>& irradianceFromBelow);
    void useForLight(const Frame& frame, const gl::Program& program, int light) const;

    PixelLight direct_, blocks_; ///< of each pixel; of each block
    std::uint64_t blocksVersion_ = 0; ///< of the last blocks that were new
    bool hasNewBlocks_ = false;
    PixelGather gather_;
    SharedGather shared_;
    /// Of what is on the graphics card: who has gathered it, and his version.
    struct GatheredVersion {
        bool isShared = false;
        std::uint64_t version = 0;
        friend bool operator==(const GatheredVersion&, const GatheredVersion&) = default;
    };
    GatheredVersion gathered_;
    bool hasGathered_ = false;
    std::uint64_t version_ = 0;
    /// The direct light of a light on the graphics card.
    struct UploadedShares {
        std::uint64_t version = 0;
        bool ofBlocks = false, isPreview = false;
        gl::Texture2D texture{};
    };
    std::vector<UploadedShares> shares_;
    gl::Texture2D irradiance_;
    gl::Program reflected_{"surface.vert", "radiosity/pixel_light.frag"};
    gl::Program gatheredLight_{"surface.vert", "radiosity/gathered.frag"};
    gl::Program visibility_{"surface.vert", "radiosity/pixel_light.frag", {"VISIBILITY_ONLY"}};
};

} // namespace shadowlab::radiosity

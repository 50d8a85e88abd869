// The room of a scene with its form factors, and what each light brings to it: key in slices, and cached for as long as it is right.
//
// Form factors know nothing of light. A lamp that moves, or changes its brightness, has what it brings straight to the patches
// found anew, and the equations solved again; only when a surface moves all begins from the start.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "techniques/radiosity/display/surface_cells.h"
#include "techniques/radiosity/exchange/prepared_exchange.h"
#include "techniques/radiosity/lights/direct_light.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room/room.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

/// Less work than this is not worth a picture in between, and a deadline that has always passed already must not stop all progress.
constexpr std::chrono::milliseconds kLeastWork{10};

class RoomCache {
public:
    /// Does what is new in the scene and the settings, until it is done (true) or the time has come, but always a bit. Form factors
    /// that are to be drawn are left for somebody who has a context of GL.
    bool advance(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline);
    [[nodiscard]] double done() const;

    // From here on: after advance() has returned true.

    [[nodiscard]] const Room& room() const { return *room_; }
    /// False: they are to be drawn (hemicube_exchange.h), and then set.
    [[nodiscard]] bool hasFormFactors() const { return exchange_.has_value(); }
    void setDrawnFormFactors(ExchangeMatrix found, int hemicubeSide);
    [[nodiscard]] const PreparedExchange& exchange() const { return *exchange_; }
    /// Have patches been cut by their light?
    [[nodiscard]] bool isRefined() const { return key_.refine > 0; }
    [[nodiscard]] const SurfaceCells& cells() const { return *cells_; }
    [[nodiscard]] const DirectLight& light(int light) const { return *lights_[static_cast<std::size_t>(light)].found; }
    [[nodiscard]] std::vector<const DirectLight*> lights() const;
    /// Another number whenever the room or its form factors have been key anew.
    [[nodiscard]] std::uint64_t version() const { return version_; }

private:
    /// What the room depends on.
    struct Surface {
        const scene::Mesh* mesh;
        dmat4 worldFromObject;
        std::vector<std::uint32_t> materials;
        std::vector<bool> emits;
        bool casts, receives, isLight;
        friend bool operator==(const Surface&, const Surface&) = default;
    };
    struct RoomCacheKey {
        std::vector<Surface> surfaces;
        RoomSettings settings;
        int budget = 0, refine = 0;
        double refineThreshold = 0;
        std::vector<scene::Light> lights; ///< if patches are cut by their light
        friend bool operator==(const RoomCacheKey&, const RoomCacheKey&) = default;
    };
    struct CachedLight {
        scene::Light light;
        std::optional<DirectLight> found;
        std::unique_ptr<DirectLightBuilder> builder;
    };
    void update(const scene::Snapshot& snapshot, const RadiosityParams& params);
    bool refineOnce();
    bool findFormFactors(const RadiosityParams& params, Deadline deadline);
    bool advanceLights(Deadline deadline);

    scene::Snapshot snapshot_, roomSnapshot_; ///< as it is now, and as the room was key of it
    std::vector<scene::Bounds> bounds_;
    scene::Revisions boundsRevisions_{0, 0, 0, 0};
    RoomCacheKey key_;
    RadiosityParams params_;
    std::unique_ptr<Room> room_;
    // Form factors as they were found: cached, for there is more than one way to use them.
    struct FoundFormFactors {
        ExchangeMatrix matrix;
        ExchangeCounts counts;
        std::vector<double> rowDeviations;
    };
    void use(const FoundFormFactors& found);
    std::unique_ptr<ExchangeBuilder> builder_;
    // While patches are being refined: what was found before the last round, and which patch is which.
    int rounds_ = 0;
    std::unique_ptr<ExchangeBuilder> builderBefore_;
    ExchangeMatrix matrixBefore_{0};
    std::vector<std::uint32_t> from_;
    std::optional<FoundFormFactors> analytic_, drawn_;
    int drawnSide_ = 0; ///< of the hemicube
    /// What is used, and by which settings it was key.
    std::optional<PreparedExchange> exchange_;
    RadiosityParams::FormFactors exchangeKind_{};
    bool isScaled_ = false;
    std::optional<SurfaceCells> cells_;
    std::vector<std::uint8_t> receives_; ///< of each patch
    std::vector<CachedLight> lights_;
    std::uint64_t version_ = 0;
};

} // namespace shadowlab::radiosity

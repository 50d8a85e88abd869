// Caches a scene's room, its form factors, and the direct light on its patches; each is recomputed only when what it depends on
// changes.
//
// Form factors do not depend on light. When a lamp moves or changes its brightness, only the direct light is recomputed and the
// equations are solved again; only when a surface moves does everything start from the beginning.
// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <memory>
#include <optional>

#include "techniques/radiosity/display/mesh_aim.h"
#include "techniques/radiosity/display/surface_cells.h"
#include "techniques/radiosity/exchange/prepared_exchange.h"
#include "techniques/radiosity/lights/direct_light.h"
#include "techniques/radiosity/lights/lamps_between.h"
#include "techniques/radiosity/lights/path_light.h"
#include "techniques/radiosity/params.h"
#include "techniques/radiosity/room/room.h"
#include "techniques/technique.h"

namespace shadowlab::radiosity {

/// Work continues at least so long: a picture after less is not worth drawing, and a deadline that has already passed must not
/// stop all progress.
constexpr std::chrono::milliseconds kLeastWork{10};

class RoomCache {
public:
    /// Recomputes what has changed in the scene and the settings, until it is done (true) or the deadline has passed, but always
    /// does some work. Form factors by hemicubes are left to the caller, who has the GL context.
    /// `eye`: for which a new room is cut; one that is kept stays as it is cut.
    bool advance(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline, const std::optional<Eye>& eye = {});
    [[nodiscard]] double done() const;

    // The functions below may be called once advance() has returned true.

    [[nodiscard]] const Room& room() const { return *room_; }
    /// Would a new room be cut like this one?
    [[nodiscard]] bool isCutFor(const std::optional<Eye>& eye);
    /// False: they must be drawn (hemicube_exchange.h) and set by setDrawnFormFactors().
    [[nodiscard]] bool hasFormFactors() const { return exchange_.has_value(); }
    void setDrawnFormFactors(ExchangeMatrix found, int hemicubeSide);
    /// Without what meets lamps on its way, if the picture shows direct light by pixels.
    [[nodiscard]] const PreparedExchange& exchange() const { return *exchange_; }
    /// Are patches refined by the light on them?
    [[nodiscard]] bool isRefined() const { return key_.refine > 0; }
    [[nodiscard]] const SurfaceCells& cells() const { return *cells_; }
    /// To the mesh of an object, as it is drawn. Found when first asked for; not to be asked for by several threads at a time.
    [[nodiscard]] const MeshAim& aimOf(std::uint32_t object) const;
    [[nodiscard]] const DirectLight& light(int light) const { return *lights_[static_cast<std::size_t>(light)].found; }
    [[nodiscard]] const LightSource& source(int light) const { return *lights_[static_cast<std::size_t>(light)].source; }
    [[nodiscard]] std::vector<const DirectLight*> lights() const;
    /// What light brings that is followed along paths; empty where there is none, or the picture does not show
    /// direct light by pixels.
    [[nodiscard]] const PathLight& pathLight() const { return pathLight_; }
    [[nodiscard]] const Followed& followed() const { return followed_; }
    [[nodiscard]] bool isFollowed(std::size_t patch) const { return followed_.hasPatch(patch); }
    /// Changes whenever the room or its form factors are recomputed.
    [[nodiscard]] std::uint64_t version() const { return version_; }

private:
    /// What the room depends on: while it is equal, the room is kept.
    struct Surface {
        const scene::Mesh* mesh;
        dmat4 worldFromObject;
        std::vector<std::uint32_t> materials;
        std::vector<std::pair<bool, bool>> shines; ///< of each part: from its front, and from its back
        bool casts, receives, isLight;
        friend bool operator==(const Surface&, const Surface&) = default;
    };
    struct RoomCacheKey {
        std::vector<Surface> surfaces;
        RoomSettings settings;
        int budget = 0, refine = 0;
        double refineThreshold = 0;
        std::vector<scene::Light> lights; ///< only if patches are refined by their light
        friend bool operator==(const RoomCacheKey&, const RoomCacheKey&) = default;
    };
    struct CachedLight {
        scene::Light light;
        std::optional<LightSource> source;
        std::optional<DirectLight> found;
        std::unique_ptr<DirectLightBuilder> builder;
    };
    void update(const scene::Snapshot& snapshot, const RadiosityParams& params, const std::optional<Eye>& eye);
    bool refineOnce();
    bool findFormFactors(const RadiosityParams& params, Deadline deadline);
    bool advanceLights(Deadline deadline);
    /// What is drawn of a lamp; nullptr: nothing.
    [[nodiscard]] const scene::Object* bodyOf(std::size_t light) const;
    /// Has the lamp a body, and is that no rect that lies on a surface? Where one does, the surface reflects nothing that it covers (lamp_cover.h).
    [[nodiscard]] bool hangsFreely(std::size_t light) const;
    bool advanceLamps(Deadline deadline);
    void findFreeLamps();
    void findFollowed();
    bool advanceLampsBetween(Deadline deadline);
    void leaveWhatPassesLamps();
    [[nodiscard]] Followed lightToFollow() const;
    bool advancePathLight(Deadline deadline);

    scene::Snapshot snapshot_, roomSnapshot_; ///< as it is now, and as it was when the room was built
    std::vector<scene::Bounds> bounds_;
    scene::Revisions boundsRevisions_{0, 0, 0, 0};
    RoomCacheKey key_;
    RadiosityParams params_;
    std::unique_ptr<Room> room_;
    std::optional<Eye> lastEye_; ///< that isCutFor() was asked for, or for which the room was cut
    bool isCutForLastEye_ = true;
    // Form factors before scaling: there is more than one way to use them.
    struct FoundFormFactors {
        ExchangeMatrix matrix;
        ExchangeCounts counts;
        std::vector<double> rowDeviations;
    };
    void use(const FoundFormFactors& found);
    std::unique_ptr<ExchangeBuilder> builder_;
    // During refinement: the results of the previous round, and which patch is which.
    int rounds_ = 0;
    std::unique_ptr<ExchangeBuilder> builderBefore_;
    ExchangeMatrix matrixBefore_{0};
    std::vector<std::uint32_t> from_;
    std::optional<FoundFormFactors> analytic_, drawn_;
    int drawnSide_ = 0; ///< of the hemicube
    /// The form factors in use, and the settings they were made with.
    std::optional<PreparedExchange> exchange_;
    RadiosityParams::FormFactors exchangeKind_{};
    bool isScaled_ = false;
    std::optional<SurfaceCells> cells_;
    mutable std::map<std::uint32_t, MeshAim> aims_; ///< by object
    std::vector<std::uint8_t> receives_; ///< for each patch: does it receive shadow? 1 or 0
    std::vector<CachedLight> lights_;
    bool areLampsKnown_ = false;          ///< false: something has changed since what follows was found
    std::vector<std::uint8_t> isFree_;    ///< for each light, 1 if it is a lamp that hangs freely, else 0
    std::vector<scene::Light> freeLamps_; ///< those, as they were when lines past them were sent, but for their brightness
    std::unique_ptr<LampsBetweenBuilder> lampsBuilder_;
    std::vector<PairValue> pastLamps_;
    std::optional<std::vector<PairValue>> beforeLamps_; ///< what exchange_ had there; none: it has all of it
    Followed followed_;
    std::vector<scene::Light> followedLights_; ///< as they were when their light was followed
    std::unique_ptr<PathLightBuilder> pathBuilder_;
    PathLight pathLight_;
    std::uint64_t version_ = 0;
};

} // namespace shadowlab::radiosity

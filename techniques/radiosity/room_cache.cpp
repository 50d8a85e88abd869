// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room_cache.h"

#include <algorithm>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/room/patch_memory.h"

namespace shadowlab::radiosity {

namespace {

// Sample lines of a patch if all of its pairs were partly visible: the standard deviation of a row sum is then below a hundredth.
constexpr double kLinesPerPatch = 1e4;

/// Does the light shine into the inside of the box? It may lie in a side of the box: what shines to one side is looked at from a
/// little before it, and what shines to all sides counts from its border on.
bool shinesInto(const scene::Light& light, const scene::Bounds& box) {
    if (box.isEmpty() || light.type == scene::LightType::directional) return false;
    const double step = kTouching * glm::length(box.upperWorld - box.lowerWorld);
    const auto isWithin = [&](const dvec3& p, double margin) {
        return glm::all(glm::greaterThan(p, box.lowerWorld - margin)) &&
               glm::all(glm::lessThan(p, box.upperWorld + margin));
    };
    const dvec3& middle = light.positionWorld;
    switch (light.type) {
    case scene::LightType::rect:
        for (const double u : {-0.5, 0.0, 0.5})
            for (const double v : {-0.5, 0.0, 0.5})
                if (isWithin(
                        middle + u * light.edgeUWorld + v * light.edgeVWorld + step * scene::rectNormalWorld(light), 0))
                    return true;
        return false;
    case scene::LightType::spot: return isWithin(middle + step * light.directionWorld, 0);
    case scene::LightType::sphere:
        return glm::distance(middle, glm::clamp(middle, box.lowerWorld, box.upperWorld)) < light.radius;
    default: return isWithin(middle, step);
    }
}

} // namespace

void RoomCache::update(const scene::Snapshot& snapshot, const RadiosityParams& params, const std::optional<Eye>& eye) {
    snapshot_ = snapshot;
    areLampsKnown_ = false;
    const scene::Revisions& now = snapshot->revisions;
    if (bounds_.empty() || boundsRevisions_.geometry != now.geometry || boundsRevisions_.transforms != now.transforms)
        bounds_ = scene::objectBounds(*snapshot);
    boundsRevisions_ = now;
    RoomCacheKey key;
    key.budget = params.patches;
    key.refine = params.formFactors == RadiosityParams::FormFactors::analytic ? params.refine : 0;
    if (key.refine > 0) {
        key.refineThreshold = params.refineThreshold;
        key.lights = snapshot->lights;
    }
    key.settings.patches = static_cast<std::size_t>(key.refine > 0 ? (params.patches + 2) / 3 : params.patches);
    key.settings.cutsAtContacts = params.cutAtContacts;
    for (std::size_t o = 0; o < snapshot->objects.size(); ++o) {
        const scene::Object& object = snapshot->objects[o];
        const bool isLight = object.emitterOfLight >= 0;
        key.settings.lightWithin.push_back(
            !isLight && std::ranges::any_of(snapshot->lights,
                                            [&](const scene::Light& light) { return shinesInto(light, bounds_[o]); }));
        // The room does not depend on where lights are, or how bright: their surfaces have no entry of their own.
        Surface surface{isLight ? nullptr : object.mesh.get(),
                        isLight ? dmat4(1) : object.worldFromObject,
                        {},
                        {},
                        object.castsShadow,
                        object.receivesShadow,
                        isLight};
        if (!isLight)
            for (const std::uint32_t material : object.partMaterials) {
                surface.materials.push_back(material);
                surface.shines.emplace_back(scene::shinesFrom(snapshot->materials[material], true),
                                            scene::shinesFrom(snapshot->materials[material], false));
            }
        key.surfaces.push_back(std::move(surface));
    }
    if (room_ && key == key_) return;
    key_ = std::move(key);
    roomSnapshot_ = snapshot;
    lights_.clear();
    receives_.clear();
    builder_.reset();
    builderBefore_.reset();
    rounds_ = 0;
    analytic_.reset();
    drawn_.reset();
    exchange_.reset();
    freeLamps_.clear();
    lampsBuilder_.reset();
    pastLamps_.clear();
    followed_ = {};
    followedLights_.clear();
    pathBuilder_.reset();
    pathLight_ = {};
    cells_.reset();
    aims_.clear();
    room_ = std::make_unique<Room>(*roomSnapshot_, key_.settings, eye);
    lastEye_ = eye;
    isCutForLastEye_ = true;
    version_ = scene::newRevision();
}

bool RoomCache::isCutFor(const std::optional<Eye>& eye) {
    if (lastEye_ != eye) isCutForLastEye_ = room_->importance().cutsLike(room_->importanceTo(eye));
    lastEye_ = eye;
    return isCutForLastEye_;
}

bool RoomCache::advance(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline, const std::optional<Eye>& eye) {
    if (snapshot != snapshot_ || params != params_) update(snapshot, params, eye);
    params_ = params;
    deadline = std::max(deadline, std::chrono::steady_clock::now() + kLeastWork);
    if (!room_->advance(deadline)) return false;
    requireFewPatches(params.solver, room_->patches().size());
    do {
        requireMemory(*roomSnapshot_, room_->patches().size(), bytesPerPair(params.solver));
        if (!findFormFactors(params, deadline) || !advanceLights(deadline)) return false;
    } while (refineOnce());
    if (!cells_) {
        if (std::chrono::steady_clock::now() >= deadline) return false; // they may take a tenth of a second
        cells_ = surfaceCells(*roomSnapshot_, *room_);
    }
    return advanceLamps(deadline);
}

/// Cuts some patches by the light on them. False: none need cutting, or all rounds are done.
bool RoomCache::refineOnce() {
    // Each round may add half as many patches: the next one sees better where to cut.
    constexpr double kGrowth = 1.5;
    // The tolerance of a solution that only decides which patches are cut.
    constexpr double kTolerance = 1e-2;
    const bool isDone = rounds_ >= key_.refine;
    if (!isDone) {
        const Sources sources = sourcesOf(*room_, lights(), dvec3(0));
        LightBalance balance;
        balance.restart(*exchange_, sources, SolverKind::conjugateGradients);
        balance.advance({kTolerance, 0}, 0, Deadline::max());
        RefinementLimits limits;
        limits.mostPatches = std::min(static_cast<std::size_t>(key_.budget),
                                      static_cast<std::size_t>(kGrowth * static_cast<double>(room_->patches().size())));
        limits.smallestError = key_.refineThreshold;
        const std::size_t count = room_->patches().size();
        std::vector<DirectLight> found; // of the patches that exchange light
        for (const DirectLight* light : lights()) {
            found.push_back(*light);
            found.back().irradiance.resize(count);
            found.back().visible.resize(count);
            found.back().mayHaveEdge.resize(count);
            found.back().seenArea.resize(count);
        }
        const std::vector<Refinement> refinements = patchesToRefine(
            room_->patches(), patchBorders(room_->exchangingFaces(), room_->patches()),
            std::span(balance.radiosity()).first(count), std::span(sources.reflectance).first(count), found, limits);
        if (!refinements.empty()) {
            ++rounds_;
            from_ = room_->refine(refinements);
            builderBefore_ = std::move(builder_);
            matrixBefore_ = std::move(analytic_->matrix);
            analytic_.reset();
            exchange_.reset();
            lights_.clear();
            receives_.clear();
            return true;
        }
    }
    rounds_ = key_.refine;
    builder_.reset();
    builderBefore_.reset();
    matrixBefore_ = ExchangeMatrix(0);
    return false;
}

bool RoomCache::findFormFactors(const RadiosityParams& params, Deadline deadline) {
    using enum RadiosityParams::FormFactors;
    if (exchange_ && exchangeKind_ == params.formFactors && isScaled_ == params.scaleRows &&
        (exchangeKind_ == analytic || drawnSide_ == params.hemicubeSide))
        return true;
    exchange_.reset();
    if (params.formFactors == hemicube && drawnSide_ != params.hemicubeSide) drawn_.reset();
    if (params.formFactors == analytic && !analytic_) {
        if (!builder_) {
            std::optional<KnownExchange> known;
            if (builderBefore_) known.emplace(KnownExchange{*builderBefore_, matrixBefore_, from_});
            builder_ = std::make_unique<ExchangeBuilder>(room_->exchangingFaces(), room_->patches(), room_->occlusion(),
                                                         kLinesPerPatch, known);
        }
        if (!builder_->advance(deadline)) return false;
        const ExchangeCounts counts = builder_->counts();
        std::vector<double> deviations = builder_->rowDeviations();
        analytic_ = FoundFormFactors{builder_->take(), counts, std::move(deviations)};
    }
    exchangeKind_ = params.formFactors;
    isScaled_ = params.scaleRows;
    if (exchangeKind_ == analytic || drawn_) use(exchangeKind_ == analytic ? *analytic_ : *drawn_);
    return true;
}

void RoomCache::use(const FoundFormFactors& found) {
    exchange_ = preparedExchange(found.matrix, room_->patches(), room_->surroundings(), isScaled_);
    exchange_->counts = found.counts;
    exchange_->rowDeviations = found.rowDeviations;
    beforeLamps_.reset();
    version_ = scene::newRevision();
}

void RoomCache::setDrawnFormFactors(ExchangeMatrix found, int hemicubeSide) {
    drawn_ = FoundFormFactors{std::move(found), {}, std::vector<double>(room_->patches().size(), 0.0)};
    drawnSide_ = hemicubeSide;
    use(*drawn_);
    leaveWhatPassesLamps();
}

bool RoomCache::advanceLights(Deadline deadline) {
    if (receives_.empty())
        for (const Patch& patch : room_->allPatches())
            receives_.push_back(room_->objectOf(patch).receivesShadow ? 1 : 0);
    lights_.resize(snapshot_->lights.size());
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        CachedLight& cached = lights_[i];
        const scene::Light& light = snapshot_->lights[i];
        if (cached.found && cached.light == light) continue;
        if (!cached.builder || cached.light != light) {
            cached.light = light;
            cached.found.reset();
            cached.source.emplace(light, room_->world().originWorld, room_->sides().faces);
            cached.builder = std::make_unique<DirectLightBuilder>(*cached.source, room_->allPatches(), room_->occlusion(), receives_);
        }
        if (!cached.builder->advance(deadline)) return false;
        cached.found = cached.builder->take();
        cached.builder.reset();
    }
    return true;
}

const MeshAim& RoomCache::aimOf(std::uint32_t object) const {
    const auto found = aims_.find(object);
    return found != aims_.end() ? found->second : aims_.try_emplace(object, *roomSnapshot_, roomSnapshot_->objects[object]).first->second;
}

std::vector<const DirectLight*> RoomCache::lights() const {
    std::vector<const DirectLight*> all;
    for (const CachedLight& cached : lights_)
        all.push_back(&*cached.found);
    return all;
}

double RoomCache::done() const {
    // Form factors take most of the time.
    return exchange_ ? 0.95 : builder_ ? 0.05 + 0.9 * builder_->done() : 0.0;
}

} // namespace shadowlab::radiosity

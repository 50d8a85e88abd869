// SPDX-License-Identifier: MIT
#include "techniques/radiosity/room/kept_room.h"

#include <algorithm>

#include "techniques/radiosity/equations/light_balance.h"
#include "techniques/radiosity/patches/patch_memory.h"

namespace shadowlab::radiosity {

namespace {

// As many lines as a patch would send if it saw everything in part: a row sum then scatters by less than a hundredth.
constexpr double kLinesInAll = 1e4;

bool isWithin(const dvec3& p, const scene::Bounds& box) {
    return glm::all(glm::greaterThan(p, box.lowerWorld)) && glm::all(glm::lessThan(p, box.upperWorld));
}

} // namespace

void KeptRoom::lookAt(const scene::Snapshot& snapshot, const RadiosityParams& params) {
    snapshot_ = snapshot;
    const scene::Revisions& now = snapshot->revisions;
    if (bounds_.empty() || boundsOf_.geometry != now.geometry || boundsOf_.transforms != now.transforms)
        bounds_ = scene::objectBounds(*snapshot);
    boundsOf_ = now;
    Made made;
    made.budget = params.patches;
    made.refine = params.formFactors == RadiosityParams::FormFactors::analytic ? params.refine : 0;
    if (made.refine > 0) {
        made.refineThreshold = params.refineThreshold;
        made.lights = snapshot->lights;
    }
    made.settings.patches = static_cast<std::size_t>(made.refine > 0 ? (params.patches + 2) / 3 : params.patches);
    made.settings.cutsAtContacts = params.cutAtContacts;
    for (std::size_t o = 0; o < snapshot->objects.size(); ++o) {
        const scene::Object& object = snapshot->objects[o];
        const bool isLight = object.emitterOfLight >= 0;
        made.settings.lightWithin.push_back(
            !isLight && std::ranges::any_of(snapshot->lights, [&](const scene::Light& light) {
                return light.type != scene::LightType::directional && isWithin(light.positionWorld, bounds_[o]);
            }));
        // Where lights are, and how bright, is none of the room's business.
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
                surface.emits.push_back(snapshot->materials[material].emission != vec3(0.0f));
            }
        made.surfaces.push_back(std::move(surface));
    }
    if (room_ && made == made_) return;
    made_ = std::move(made);
    roomOf_ = snapshot;
    lights_.clear();
    receives_.clear();
    builder_.reset();
    builderBefore_.reset();
    rounds_ = 0;
    computed_.reset();
    drawn_.reset();
    exchange_.reset();
    cells_.reset();
    room_ = std::make_unique<Room>(*roomOf_, made_.settings);
    ++version_;
}

bool KeptRoom::advance(const scene::Snapshot& snapshot, const RadiosityParams& params, Deadline deadline) {
    if (snapshot != snapshot_ || params != lookedAt_) lookAt(snapshot, params);
    lookedAt_ = params;
    deadline = std::max(deadline, std::chrono::steady_clock::now() + kLeastWork);
    if (!room_->advance(deadline)) return false;
    requireFew(params.solver, room_->patches().size());
    do {
        requireMemory(*roomOf_, room_->patches().size(), bytesPerPair(params.solver));
        if (!findFormFactors(params, deadline) || !advanceLights(deadline)) return false;
    } while (refineOn());
    if (!cells_) cells_ = surfaceCells(*roomOf_, *room_);
    return true;
}

/// Cuts some patches by what light there is on them; false: there are none to be cut, or no more rounds.
bool KeptRoom::refineOn() {
    // A round begins with half as many patches again: the next one sees better where to cut.
    constexpr double kGrowth = 1.5;
    // Of the radiosity, for a solution that only decides what is cut.
    constexpr double kTolerance = 1e-2;
    const bool isDone = rounds_ >= made_.refine;
    if (!isDone) {
        const Sources sources = sourcesOf(*room_, lights(), dvec3(0));
        LightBalance balance;
        balance.restart(*exchange_, sources, SolverKind::conjugateGradients);
        balance.advance({kTolerance, 0}, 0, Deadline::max());
        RefinementLimits limits;
        limits.mostPatches = std::min(static_cast<std::size_t>(made_.budget),
                                      static_cast<std::size_t>(kGrowth * static_cast<double>(room_->patches().size())));
        limits.smallestError = made_.refineThreshold;
        const std::size_t count = room_->patches().size();
        std::vector<DirectLight> found; // of the patches that exchange light
        for (const DirectLight* light : lights()) {
            found.push_back(*light);
            found.back().irradiance.resize(count);
            found.back().visible.resize(count);
            found.back().seenArea.resize(count);
        }
        const std::vector<Refinement> refinements = patchesToRefine(
            room_->patches(), patchBorders(room_->exchangingFaces(), room_->patches()),
            std::span(balance.radiosity()).first(count), std::span(sources.reflectance).first(count), found, limits);
        if (!refinements.empty()) {
            ++rounds_;
            from_ = room_->refine(refinements);
            builderBefore_ = std::move(builder_);
            matrixBefore_ = std::move(computed_->matrix);
            computed_.reset();
            exchange_.reset();
            lights_.clear();
            receives_.clear();
            return true;
        }
    }
    rounds_ = made_.refine;
    builder_.reset();
    builderBefore_.reset();
    matrixBefore_ = ExchangeMatrix(0);
    return false;
}

bool KeptRoom::findFormFactors(const RadiosityParams& params, Deadline deadline) {
    using enum RadiosityParams::FormFactors;
    if (exchange_ && exchangeOf_ == params.formFactors && isScaled_ == params.scaleRows &&
        (exchangeOf_ == analytic || drawnSide_ == params.hemicubeSide))
        return true;
    exchange_.reset();
    if (params.formFactors == hemicube && drawnSide_ != params.hemicubeSide) drawn_.reset();
    if (params.formFactors == analytic && !computed_) {
        if (!builder_) {
            std::optional<KnownExchange> known;
            if (builderBefore_) known.emplace(KnownExchange{*builderBefore_, matrixBefore_, from_});
            builder_ = std::make_unique<ExchangeBuilder>(room_->exchangingFaces(), room_->patches(), room_->occlusion(),
                                                         kLinesInAll, known);
        }
        if (!builder_->advance(deadline)) return false;
        const ExchangeCounts counts = builder_->counts();
        std::vector<double> deviations = builder_->rowDeviations();
        computed_ = Found{builder_->take(), counts, std::move(deviations)};
    }
    exchangeOf_ = params.formFactors;
    isScaled_ = params.scaleRows;
    if (exchangeOf_ == analytic || drawn_) use(exchangeOf_ == analytic ? *computed_ : *drawn_);
    return true;
}

void KeptRoom::use(const Found& found) {
    exchange_ = preparedExchange(found.matrix, room_->patches(), room_->surroundings(), isScaled_);
    exchange_->counts = found.counts;
    exchange_->rowDeviations = found.rowDeviations;
    ++version_;
}

void KeptRoom::setDrawnFormFactors(ExchangeMatrix found, int hemicubeSide) {
    drawn_ = Found{std::move(found), {}, std::vector<double>(room_->patches().size(), 0.0)};
    drawnSide_ = hemicubeSide;
    use(*drawn_);
}

bool KeptRoom::advanceLights(Deadline deadline) {
    if (receives_.empty())
        for (const Patch& patch : room_->allPatches())
            receives_.push_back(room_->objectOf(patch).receivesShadow ? 1 : 0);
    lights_.resize(snapshot_->lights.size());
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        KeptLight& kept = lights_[i];
        const scene::Light& light = snapshot_->lights[i];
        if (kept.found && kept.light == light) continue;
        if (!kept.builder || kept.light != light) {
            kept.light = light;
            kept.found.reset();
            kept.builder = std::make_unique<DirectLightBuilder>(
                LightSource(light, room_->world().originWorld, room_->sides().faces), room_->allPatches(),
                room_->occlusion(), receives_);
        }
        if (!kept.builder->advance(deadline)) return false;
        kept.found = kept.builder->take();
        kept.builder.reset();
    }
    return true;
}

std::vector<const DirectLight*> KeptRoom::lights() const {
    std::vector<const DirectLight*> all;
    for (const KeptLight& kept : lights_)
        all.push_back(&*kept.found);
    return all;
}

double KeptRoom::done() const {
    // By far the most of the time goes into form factors.
    return exchange_ ? 0.95 : builder_ ? 0.05 + 0.9 * builder_->done() : 0.0;
}

} // namespace shadowlab::radiosity

// The passes of planar shadows, one function each.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/planar/technique.h"

namespace shadowlab::planar {

namespace {

bool isSomewhere(const scene::PicturePart& part) { return part.lower.x < part.upper.x && part.lower.y < part.upper.y; }

} // namespace

/// Finds the planes that no pixel shows, with one occlusion query for each plane in view; once per view.
void Planar::findHidden(const Frame& frame) {
    if (hiddenIn_ == key_.view) return;
    // Waiting for the query results costs about as much as flattening everything onto this many more planes.
    constexpr std::ptrdiff_t kFew = 4;
    const auto mayBeShadowed = std::ranges::count_if(shadowedParts_, isSomewhere);
    if (!leftOut_ && !(params_.cull && (showsTags(frame) || mayBeShadowed > kFew))) return;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    tag_.use();
    std::vector<gl::QueryHandle> queries;
    for (const ChosenReceiver& one : inView_) {
        queries.push_back(gl::QueryHandle::create());
        glBeginQuery(GL_SAMPLES_PASSED, queries.back().id());
        drawReceiver(frame, tag_, one);
        glEndQuery(GL_SAMPLES_PASSED);
    }
    hiddenIn_ = key_.view;
    hidden_.clear();
    for (std::size_t i = 0; i < inView_.size(); ++i) {
        GLuint pixels = 0;
        glGetQueryObjectuiv(queries[i].id(), GL_QUERY_RESULT, &pixels);
        if (pixels == 0) hidden_.emplace(inView_[i].receiver.object, inView_[i].receiver.face);
    }
    listFor(frame);
}

// [anchor: tag-receivers]
void Planar::tagReceivers(const Frame& frame, bool everywhere) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    tag_.use();
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
        // A plane on which no shadow can fall needs no number.
        if (!everywhere && !isSomewhere(shadowedParts_[i])) continue;
        frame.scissorTo(everywhere ? scene::PicturePart{} : shadowedParts_[i]);
        // Of two planes at one depth the first drawn is visible; it has the larger number.
        glStencilFunc(GL_GREATER, chosen_[i].tag, kTagBits);
        drawReceiver(frame, tag_, chosen_[i]);
    }
}

void Planar::drawReceiver(const Frame& frame, const gl::Program& program, const ChosenReceiver& one) {
    program.set("clipFromMesh", mat4(frame.eye().clipFromMesh(frame.scene().objects[one.receiver.object])));
    for (const TriangleRun& run : one.receiver.face->runs)
        gl::drawTriangles(frame.scene(), frame.buffers(), frame.eye(), one.receiver.object, run.first, run.count);
}

// [anchor: mark-state]
void Planar::setPlaneState(const Frame& frame, const LitPlane& plane) const {
    frame.scissorTo(plane.part); // elsewhere another plane may have its number
    const GLint tagAndMark = static_cast<GLint>(kMarkBit) + plane.receiver->tag;
    glDepthMask(GL_FALSE);
    glEnable(GL_STENCIL_TEST);
    glStencilMask(kMarkBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glStencilFunc(params_.stencil ? GL_EQUAL : GL_ALWAYS, tagAndMark, kTagBits);
    if (params_.stencil) {
        glDisable(GL_DEPTH_TEST); // the shadow lies in the plane: any comparison would be of rounding
    } else {
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(0, static_cast<float>(-params_.offset));
    }
}

void Planar::markShadows(const Frame& frame, const std::vector<LitPlane>& planes) const {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (const LitPlane& plane : planes) {
        setPlaneState(frame, plane);
        if (plane.turnedAway) {
            tag_.use();
            drawReceiver(frame, tag_, *plane.receiver);
            continue;
        }
        const gl::Program& flatten = params_.divide ? flattenDivided_ : flatten_;
        drawAsAsked(frame, flatten, plane);
        hideBehind(frame, plane);
    }
}

void Planar::hideBehind(const Frame& frame, const LitPlane& plane) const {
    if (plane.hiddenBehind.empty()) return;
    glEnable(GL_CLIP_DISTANCE0);
    behind_.use();
    const dmat4 worldFromMesh = scene::worldFromMesh(frame.scene().objects[plane.receiver->receiver.object]);
    for (const dvec4& planeWorld : plane.hiddenBehind) {
        behind_.set("behindRow", vec4(-planeWorld * worldFromMesh));
        drawReceiver(frame, behind_, *plane.receiver);
    }
    glDisable(GL_CLIP_DISTANCE0);
}

/// Draws the casters between plane and light, or whole, as the parameters say.
void Planar::drawAsAsked(const Frame& frame, const gl::Program& program, const LitPlane& plane) const {
    drawFlattened(frame, program, plane, params_.clip ? Part::between : Part::wherever);
    if (!params_.clip && !params_.divide) drawFlattened(frame, program, plane, Part::whereverTurnedOver);
}

void Planar::drawFlattened(const Frame& frame, const gl::Program& program, const LitPlane& plane, Part part) const {
    glEnable(GL_CLIP_DISTANCE0);
    glEnable(GL_CLIP_DISTANCE1);
    const bool clipped = part != Part::wherever && part != Part::whereverTurnedOver;
    // Beyond the light the weight w is negative. Inverting all four signs gives the same homogeneous point with a positive
    // w.
    const bool beyond = part == Part::beyondLight || part == Part::whereverTurnedOver;
    const auto setProjection = [&](const gl::Program& used, const dmat4& worldFromCaster, double contact) {
        const dmat4 viewFromCaster = frame.eye().viewFromWorld * worldFromCaster;
        const dmat4 flattenedFromCaster = plane.projection.flattenedFromView * viewFromCaster;
        dvec4 weightRow = plane.projection.weightRow(viewFromCaster),
              heightRow = plane.projection.heightRow(viewFromCaster);
        if (part == Part::beyondLight) weightRow = -weightRow;
        if (part == Part::behindPlane) heightRow = -heightRow;
        heightRow.w -= contact;
        // Without clipping the clip distance is 1 everywhere, because Mesa clips even where GL_CLIP_DISTANCE is disabled.
        const dvec4 always(0, 0, 0, 1);
        used.use();
        used.set("sheet", beyond ? -1.0f : 1.0f);
        used.set("clipFromMeshFlattened", mat4(frame.eye().clipFromView * flattenedFromCaster));
        used.set("viewFromMeshFlattened", mat4(flattenedFromCaster));
        used.set("clipFromView", mat4(frame.eye().clipFromView));
        used.set("weightRow", vec4(clipped ? weightRow : always));
        used.set("heightRow", vec4(clipped ? heightRow : always));
    };
    if (!plane.frontsSuffice.empty() || !plane.bothSides.empty())
        setProjection(program, casters_.worldFromCaster(), plane.contact);
    if (!plane.frontsSuffice.empty()) {
        // Counter-clockwise seen from the light is counter-clockwise seen by the eye, on the same side of the plane.
        glEnable(GL_CULL_FACE);
        buffers_.draw(plane.frontsSuffice);
        glDisable(GL_CULL_FACE);
    }
    if (!plane.bothSides.empty()) buffers_.draw(plane.bothSides);
    for (const SingleCaster& single : plane.singles) {
        const Caster& caster = casters_.all()[single.caster];
        if (caster.hasHoles) setProjection(program.alphaTested(), caster.worldFromMesh, single.contact);
        setProjection(program, caster.worldFromMesh, single.contact);
        drawSingle(frame, program, single);
    }
    glDisable(GL_CLIP_DISTANCE0);
    glDisable(GL_CLIP_DISTANCE1);
}

/// With the projection set, also for the variant that cuts holes.
void Planar::drawSingle(const Frame& frame, const gl::Program& program, const SingleCaster& single) const {
    const Caster& caster = casters_.all()[single.caster];
    if (single.frontsSuffice) {
        glEnable(GL_CULL_FACE);
        glCullFace(caster.mirrored ? GL_FRONT : GL_BACK);
    }
    const std::vector<scene::MeshPart>& parts = frame.scene().objects[caster.object].mesh->parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const gl::Texture2D* mask = frame.buffers().mask(caster.object, p);
        const gl::Program& used = mask ? program.alphaTested() : program;
        used.use();
        if (mask) {
            const scene::Object& object = frame.scene().objects[caster.object];
            gl::setAlphaMask(used, frame.scene().materials[object.partMaterials[p]], *mask);
        }
        const std::uint32_t partEnd = parts[p].firstTriangle + parts[p].triangleCount;
        for (const TriangleRun& run : single.runs) {
            const std::uint32_t first = std::max(run.first, parts[p].firstTriangle);
            const std::uint32_t end = std::min(run.first + run.count, partEnd);
            if (first < end) frame.buffers().mesh(caster.object).draw(first, end - first);
        }
    }
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

void Planar::setColor(const gl::Program& program, const LitPlane& plane, const vec4& color) {
    program.use();
    program.set("color", color);
    if (plane.singles.empty()) return; // only of these may one have holes
    program.alphaTested().use();
    program.alphaTested().set("color", color);
}

// [anchor: clear-marks]
void Planar::clearBits(unsigned bits) {
    glStencilMask(bits);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilMask(~0u);
}

// [anchor: light-unmarked]
void Planar::drawLit(const Frame& frame, const gl::Program& program, int light) const {
    glStencilMask(kLitBit);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INVERT);
    gl::useForLight(program, frame.scene(), frame.buffers(), frame.eye(), light);
    if (const auto counted = counted_.find(light); counted != counted_.end()) {
        counted->second.counts.bind(gl::kFirstFreeUnit);
        program.set("shadowsOfPoints", gl::kFirstFreeUnit);
        program.set("lightPoints", static_cast<float>(counted->second.drawn));
    }
    gl::drawSurfaces(program, frame.scene(), frame.buffers(), frame.eye(), [&](const scene::Object& object) {
        // What receives no shadow ignores marks, which without the stencil's numbers may fall on anything.
        glStencilFunc(GL_EQUAL, 0, params_.once && object.receivesShadow ? kLitBit | kMarkBit : kLitBit);
        return true;
    });
}

// [anchor: darken]
void Planar::darken(const Frame& frame, int light) const {
    constexpr float kHalf = 0.5f; // what each face leaves of the light
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (const LitPlane& plane : lit_[static_cast<std::size_t>(light)]) {
        setPlaneState(frame, plane);
        glStencilMask(0);
        const gl::Program& paint = params_.divide ? paintDivided_ : paintFlattened_;
        setColor(paint, plane, vec4(0, 0, 0, kHalf));
        drawAsAsked(frame, paint, plane);
    }
}

} // namespace shadowlab::planar

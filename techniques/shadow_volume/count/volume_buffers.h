// The buffers of a caster's volume on the graphics card, to be drawn part by part.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "techniques/foundation/gl/scene/scene_buffers.h"
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

/// The vertices of a mesh twice: as they are (extrudable = 0) and to be pushed to the volume's end (extrudable = 1).
/// One per mesh, whatever the number of lights.
class ExtrusionVertices {
public:
    explicit ExtrusionVertices(const scene::Mesh& mesh);
    void bindAttributes() const;

private:
    gl::BufferHandle vertices_;
};

class VolumeBuffers {
public:
    /// `bindAttributes` binds the vertices that the volume's indices count in.
    VolumeBuffers(const Volume& volume, std::span<const SilhouetteEdge> silhouette,
                  const std::function<void()>& bindAttributes);
    // The triangles whose front faces the light, and those whose back does, which are drawn as clockwise.
    void drawTopCap() const { topCap_.draw(GL_TRIANGLES); }
    void drawTopCapReversed() const { topCapReversed_.draw(GL_TRIANGLES); }
    /// `toOnePoint`: all far vertices coincide, so half of the triangles are degenerate and are left out.
    void drawSides(bool toOnePoint = false) const { sides_.draw(GL_TRIANGLES, toOnePoint ? 2 : 1); }
    void drawBottomCap() const { bottomCap_.draw(GL_TRIANGLES); }
    // Silhouette edges as lines, by how many triangles meet there.
    void drawSilhouette() const { silhouette_.draw(GL_LINES); }
    void drawBoundary() const { boundary_.draw(GL_LINES); }
    void drawMultiple() const { multiple_.draw(GL_LINES); }

private:
    struct Run {
        gl::VertexArrayHandle vertexArray;
        gl::BufferHandle indices;
        GLsizei count = 0;
        void fill(const std::function<void()>& bindAttributes, const std::vector<std::uint32_t>& data);
        void draw(GLenum mode, GLsizei firstShare = 1) const; ///< the first 1 / `firstShare` of it
    };
    Run topCap_, topCapReversed_, sides_, bottomCap_, silhouette_, boundary_, multiple_;
};

/// Sets which winding is the front of a caster's faces; a mirrored object reverses it.
void setFrontFace(const scene::Object& object, bool clockwise);

} // namespace shadowlab::shadow_volume

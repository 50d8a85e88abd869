// A technique that paints scenes for relations, as it is or with a fault, and what is seen of it.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "tests/relations/solids.h"

namespace shadowlab::relations {

/// Of most pictures: 20,480 pixels, of which 0.02 % are four.
inline constexpr ivec2 kSize{160, 128};

/// What there is to compare of one frame.
struct Picture {
    ivec2 size{0};
    image::Image shown;                               ///< as it would be saved
    std::vector<vec4> radiance;                       ///< before exposure and encoding
    std::vector<picture::VisibilityImage> visibility; ///< of each light
    std::vector<float> texelPx; ///< of a shadow map, the largest of all lights at each pixel; empty: it has none
    int smoothPx = 0;           ///< how far apart the points are that visibility is interpolated between; 0: it is not
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    }
};

/// The picture with its pixels elsewhere: pixel (x, y) becomes what `from` says.
Picture rearranged(const Picture& picture, ivec2 size, const std::function<ivec2(ivec2)>& from);

/// What kind of technique it is, found by asking it: relations know no technique by name.
struct Traits {
    bool solvesRoom = false;     ///< surfaces light each other, so that whatever is added or cut changes all of them
    bool hasTexels = false;      ///< it has a shadow map, whose grid is laid over the scene anew when something moves
    bool servesAll = false;      ///< every surface is shadowed, curved ones as well, and as rays say away from edges
    bool servesFlat = false;     ///< the same of flat surfaces alone
    bool seesFromShadow = false; ///< the same for an eye in shadow, which counting from the eye is wrong for
};

class Painter {
public:
    /// Stands between the scene and the technique; for tests that ask whether a fault is found.
    using Fault = std::function<void(scene::Scene&)>;

    explicit Painter(std::string technique, std::vector<std::string> settings = {}, Fault fault = {});

    Picture paint(scene::Scene scene, ivec2 size = kSize, const Region& region = {});

    [[nodiscard]] const std::string& technique() const { return technique_; }
    [[nodiscard]] const Traits& traits();
    /// The scenes painted since the last forget().
    [[nodiscard]] const std::vector<scene::Scene>& painted() const { return painted_; }
    void forget() { painted_.clear(); }

private:
    [[nodiscard]] Traits findTraits();
    /// Is its visibility what rays say, but for few pixels?
    [[nodiscard]] bool isRight(const scene::Scene& scene);
    std::string technique_;
    Fault fault_;
    picture::Slot slot_; ///< one for all scenes: what it keeps of one must not show in the next
    picture::PictureEncoder encoder_;
    std::vector<scene::Scene> painted_;
    std::optional<Traits> traits_;
};

/// One for every registered technique.
std::vector<std::string> registeredIds();

} // namespace shadowlab::relations

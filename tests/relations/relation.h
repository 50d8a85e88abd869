// A relation: what must be true of two pictures of scenes that belong together, whatever the scenes are.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tests/relations/painter.h"
#include "tests/relations/recipe.h"

namespace shadowlab::relations {

/// How alike two pictures have to be. Whoever interpolates visibility between points of a room differs, but for `exact`, as far
/// as these points reach: they lie elsewhere as soon as anything does.
enum class Gate {
    exact, ///< every pixel, wherever the arithmetic is the same
    /// But for few pixels at edges: vertices that come to lie elsewhere round to other places of the rasteriser's grid.
    edges,
    /// The same, and the grid of a shadow map is laid anew: whoever has one may differ wherever its texels reach.
    edgesAndTexels,
};

/// Pictures held against each other, or one against what must be true of it.
struct Comparison {
    long compared = 0;  ///< pixels
    long lit = 0;       ///< surfaces with more than half of a light, for each light
    long shadowed = 0;  ///< with less
    long different = 0; ///< pixels that break the relation
    long stray = 0;     ///< of those, the ones that no edge excuses
    ivec2 where{-1};    ///< one that breaks it, stray if there is one
    Gate gate = Gate::exact;
    Comparison& operator+=(const Comparison& other);
};
std::ostream& operator<<(std::ostream& stream, const Comparison& comparison);

struct Relation {
    std::string_view id;                        ///< kebab-case
    std::string_view says;                      ///< one line
    bool (*appliesTo)(const Traits&) = nullptr; ///< none: to all techniques
    Comparison (*check)(const Recipe&, Painter&) = nullptr;
};

/// Of scene, eye and lights moved together, of meshes written otherwise, of parts of a picture; of lights; of casters and
/// what rays say of them.
std::vector<Relation> motionRelations();
std::vector<Relation> meshRelations();
std::vector<Relation> frameRelations();
std::vector<Relation> lightRelations();
std::vector<Relation> casterRelations();
/// All of them.
std::vector<Relation> allRelations();

/// Pictures and visibilities, pixel by pixel: more than two of 255 levels are a difference; with Gate::exact any. Lit and
/// shadowed are those of the first.
Comparison compare(const Picture& expected, const Picture& actual, Gate gate);

/// Is there an edge (of a surface or a shadow) within so many pixels, for the picture or a visibility?
bool isNearEdge(const Picture& picture, ivec2 pixel, int reachPx);

/// How far from an edge two pictures may differ: one pixel, and where a map is laid anew the three texels that bias and kernel
/// reach, of the coarser one.
int reachPx(const Picture& a, const Picture& b, ivec2 pixel, Gate gate);

/// Surfaces of the picture with more and with less than half of a light.
void countLight(const Picture& picture, Comparison& comparison);

/// May all pixels near edges differ?
bool mayDifferAtAllEdges(Gate gate, const Traits& traits);

/// What is wrong with the comparison of one recipe; empty: nothing.
std::string complaint(const Comparison& comparison, const Traits& traits);

/// Random numbers for what a relation chooses.
class Choice {
public:
    explicit Choice(const Recipe& recipe) : state_(recipe.chance) {}
    /// 0 .. below - 1
    unsigned operator()(unsigned below);

private:
    std::uint64_t state_;
};

} // namespace shadowlab::relations

// What the texel of a shadow map holds that one pixel is compared with, and how it is compared.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// The way from the point to a texel of the map, and what it is compared with there.
struct MapProbe {
    /// One comparison of the filter.
    struct Tap {
        ivec2 texel{0};
        double stored = 1;       ///< 0..1; 1: nothing
        double compared = 0;     ///< the receiver's depth, bias included
        double weight = 0;       ///< share of the answer
        bool isLit = true;       ///< of a search: it is no blocker
        dvec2 placeTexels{0.0};  ///< where the map is asked, column and row: (0.5, 0.5) is the centre of texel (0, 0)
        dvec3 onPlaneWorld{0.0}; ///< the place of the receiver's plane that the light sees there
    };
    /// What percentage-closer soft shadows do before they compare.
    struct BlockerSearch {
        std::vector<Tap> looks;    ///< depths that were looked at
        int found = 0;             ///< of them, nearer to the light than the point: blockers
        double receiverMetres = 0; ///< d_r: of the point, from the light, at right angles to its surface
        double blockerMetres = 0;  ///< d_b: the mean of the blockers
        double lightMetres = 0;    ///< w_L, width of the light; of a directional one at a distance of 1 m
        double penumbraMetres = 0; ///< w = w_L (d_r - d_b) / d_b, or less, where the kernel may not be as wide
        double searchTexels = 0;   ///< the farthest place that the search looks at, from the point's own
        double kernelTexels = 0;   ///< and that the filter compares at
    };
    /// What the filters read that average what depths become.
    struct Moments {
        /// Chebyshev's inequality for one of the warped depths, or Hamburger's problem.
        struct Bound {
            std::string of;      ///< "z", "exp(c z)"
            double compared = 0; ///< the point's own
            double mean = 0, variance = 0;
            double visibility = 1; ///< at most this share of the depths is at or beyond it
        };
        double depth = 0; ///< z of the point: -1 at the map's near side, 1 at its far side
        std::vector<std::pair<std::string, double>> read; ///< name and value of each number, interpolated
        std::vector<Bound> bounds;                        ///< none: a product stands for the comparison
        double unreduced = 1;                             ///< the least of the bounds, or the product
        double visibility = 1;                            ///< with the light that bleeds taken off
        bool isFinite = true;                             ///< false: the format did not hold a number
    };
    /// A texel that the plane of the drawing passes through: between two rays of the light, up to the stored depth.
    struct Cell {
        ivec2 texel{0};
        std::array<dvec2, 2> rays{};     ///< where the rays begin, in the plane: at the light, or before a parallel map
        std::array<dvec2, 2> stored{};   ///< where the stored depth cuts them
        std::array<dvec2, 2> compared{}; ///< where the compared depth does
        bool isEmpty = true;             ///< nothing is stored
    };
    /// A picture taken from the light that the technique has drawn for the same view, and the point's place in it.
    struct InPicture {
        std::string stage;
        dvec2 share{0.0}; ///< of the picture's width and height, from its upper left corner
    };
    int layer = 0, layers = 1;
    std::string layerName; ///< "cascade 2 of 3", "face +x"
    /// From world axes around `originWorld`, the light or the middle of the scene, into the map's clip space.
    dmat4 lightClipFromLightRelative{1.0};
    dvec3 originWorld{0.0};
    int resolution = 0;
    ivec2 texel{0};
    dvec3 str{0.0};      ///< the point's place in the map and its depth, 0..1
    double first = 1;    ///< depth of the first surface at the texel's centre, before any offset; 1: nothing
    double stored = 1;   ///< what the map holds
    double compared = 0; ///< depth that is compared with it: of the point, less the bias
    double firstMetres = 0, storedMetres = 0, comparedMetres = 0, pointMetres = 0; ///< along the light's axis
    double texelMetres = 0;                      ///< across a texel at the point, at right angles to the light
    std::optional<dvec3> blockerWorld{};         ///< of the first surface, at the texel's centre
    std::vector<Tap> taps;                       ///< comparisons of the filter; none where it averages depths
    std::optional<BlockerSearch> search{};       ///< of the filter pcss
    std::optional<Moments> moments{};            ///< of the filters vsm to msm
    std::array<dvec3, 4> texelOnReceiverWorld{}; ///< the texel projected onto the point's plane
    bool texelIsOnReceiver = false;              ///< all four corners meet it
    std::vector<InPicture> inPictures{};         ///< stages that show this light's maps, as far as they were drawn
    std::vector<Cell> near, across;              ///< of the plane: beside the point; all over the map, some of them
};

} // namespace shadowlab

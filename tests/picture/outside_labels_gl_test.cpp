// What stands in the picture from outside explains itself: labels where the things are, a colour for each meaning, one volume.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <map>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/picture/outside_fixture.h"

namespace shadowlab::picture {
namespace {

using OutsideLabelsTest = OutsideViewTest;

/// A colour as an eye has it: CIELAB of sRGB's white, and as two kinds of colour-blind people have it, by the matrices of Machado,
/// Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", 2009.
std::array<dvec3, 3> seenAs(const vec3& colorLinear) {
    // Rows of a matrix are columns here: glm counts by columns, so all three are written transposed.
    const dmat3 xyzFromRgb(0.4124, 0.2126, 0.0193, 0.3576, 0.7152, 0.1192, 0.1805, 0.0722, 0.9505);
    const dmat3 protan(0.152286, 0.114503, -0.003882, 1.052583, 0.786281, -0.048116, -0.204868, 0.099216, 1.051998);
    const dmat3 deutan(0.367322, 0.280085, -0.011820, 0.860646, 0.672501, 0.042940, -0.227968, 0.047413, 0.968881);
    const auto lab = [&](const dvec3& rgb) {
        const dvec3 xyz = xyzFromRgb * glm::clamp(rgb, dvec3(0), dvec3(1)) / dvec3(0.9505, 1.0, 1.089);
        const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
        return dvec3(116 * f(xyz.y) - 16, 500 * (f(xyz.x) - f(xyz.y)), 200 * (f(xyz.y) - f(xyz.z)));
    };
    const dvec3 rgb(colorLinear);
    return {lab(rgb), lab(protan * rgb), lab(deutan * rgb)};
}

/// Things that mean the same share a colour: what the eye sees, what blocks a light, what lets it through, one map's parts.
std::string meaningOf(const std::string& label) {
    const auto has = [&](std::string_view words) { return label.find(words) != std::string::npos; };
    // The name of a ray or a vector has the colour of its line: R1, T, N.
    if (label.size() <= 2 && label[0] == 'R') return "reflection rays";
    if (label.size() <= 2 && label[0] == 'T') return "refraction rays";
    if (label.size() == 1 && label != "r") return "eye";
    if (has("eye") || label == "the pixel's ray") return label.starts_with("-1") || label.starts_with("+1") ? label : "eye";
    if (has(": lit") || label == "r") return "lit";
    if (has("blocked") || has("in shadow") || has("blocks") || has("shadow") || label == "to what the texel holds")
        return has("shadow map") ? "map" : "blocked";
    if (has("of the map") || has("cascade")) return label.starts_with("cascade") ? label : "map";
    return label;
}

// The labels' text is not looked at as pixels: that of the plates is what the font draws, which has tests of its own.
TEST_F(OutsideLabelsTest, LabelsStandApartAndWithinThePictureAtWhatTheyName) {
    int labelled = 0, dots = 0;
    for (const char* id : {"shadow-volume-zfail", "shadow-map", "ray-traced", "planar"}) {
        const image::Image image = picture(id);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const PlacedLabel& label = labels[i];
            ++labelled;
            EXPECT_GE(label.box.lower.x, 0) << label.text;
            EXPECT_GE(label.box.lower.y, 0) << label.text;
            EXPECT_LE(label.box.upper.x, kSize.x) << label.text;
            EXPECT_LE(label.box.upper.y, kSize.y) << label.text;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(label.box.overlaps(labels[k].box)) << id << ": " << label.text << " and " << labels[k].text;
            // The bar at the left of the plate has the thing's colour, down to rounding.
            const ivec2 bar(label.box.lower + dvec2(1, 3));
            EXPECT_TRUE(isColor(image.at(bar.x, bar.y), label.colorLinear)) << id << ": " << label.text;
            // A line ends at the thing in a dot of its colour. Where two things lie in one place, as the eye and its near plane may, one
            // of the dots covers the other.
            const bool isCovered = std::ranges::any_of(labels, [&](const PlacedLabel& other) {
                return &other != &label && !other.standsOnIt() && glm::length(other.place - label.place) < 8;
            });
            if (!label.standsOnIt() && !isCovered) {
                ++dots;
                const ivec2 dot(glm::clamp(label.place, dvec2(0), dvec2(kSize - 1)));
                EXPECT_TRUE(isColor(image.at(dot.x, dot.y), label.colorLinear)) << id << ": " << label.text;
            }
        }
    }
    EXPECT_GE(labelled, 20);
    EXPECT_GE(dots, 8);
}

TEST_F(OutsideLabelsTest, SmallPicturesLabelWhatIsMostImportant) {
    outside.size = {180, 120};
    picture("shadow-volume-zfail");
    ASSERT_GE(labels.size(), 1u);
    EXPECT_LE(labels.size(), 4u);
    EXPECT_EQ(labels[0].text, "eye");
    EXPECT_FALSE(key.empty()) << "what has no label is in the key";
}

TEST_F(OutsideLabelsTest, OneVolumeIsShownAndAllOnRequest) {
    scene::Scene two = *session->snapshot();
    testing::addObject(two, scene::makeSphere(0.3, 12), testing::translation({1.6, 0.5, 0.4}));
    two.revisions.geometry = scene::newRevision();
    use(two);
    const auto shown = [&](const OutsideChoice& choice) {
        Slot slot = Session::makeSlot("shadow-volume-zfail");
        OutsideView view;
        look.choice = choice;
        picture(view, slot);
        std::map<std::string, std::size_t> points;
        for (const SceneShape& shape : view.shownShapes())
            points[shape.label] += shape.pointsWorld.size();
        return points;
    };
    auto one = shown({}), all = shown({.allVolumes = true, .caster = {}, .nearClipPyramid = false});
    EXPECT_GE(one["sides"], 3u * 8);
    EXPECT_EQ(one.count("near-clip pyramid"), 0u);
    const std::size_t last = two.objects.size() - 1;
    std::size_t sides = 0, casters = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const auto of = shown({.allVolumes = false, .caster = i, .nearClipPyramid = true});
        EXPECT_EQ(of.at("near-clip pyramid"), 16u);
        if (of.at("sides") == one["sides"] && i != last) continue; // no caster: the program's own choice, counted below
        sides += of.at("sides");
        ++casters;
    }
    EXPECT_GE(casters, 1u);
    EXPECT_EQ(all["sides"], sides + one["sides"]) << "each caster's volume once";
    EXPECT_GT(all["sides"], one["sides"]);
}

TEST_F(OutsideLabelsTest, NoColourMeansTwoThings) {
    // Of the palette the nearest two that are seen together, a method's box and a face that counts -1, are 16.6 apart (normal sight)
    // and 11.3, a light's grey and a volume's sides, for who sees no green. Below 10 colours of thin lines are taken for each other.
    constexpr double kApart = 16, kApartBlind = 10;
    int pairs = 0;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
        for (const bool isPicked : {false, true}) {
            eye.picked = isPicked ? std::optional(ivec2(kSize.x / 2, kSize.y * 2 / 3)) : std::nullopt;
            look.choice = {.allVolumes = true, .caster = {}, .nearClipPyramid = true};
            picture(std::string(technique.info->id));
            const std::vector<KeyEntry> all = things();
            for (std::size_t i = 0; i < all.size(); ++i)
                for (std::size_t k = 0; k < i; ++k) {
                    if (meaningOf(all[i].label) == meaningOf(all[k].label)) continue;
                    ++pairs;
                    const auto a = seenAs(all[i].colorLinear), b = seenAs(all[k].colorLinear);
                    for (std::size_t sight = 0; sight < a.size(); ++sight)
                        EXPECT_GE(glm::length(a[sight] - b[sight]), sight == 0 ? kApart : kApartBlind)
                            << technique.info->id << ": " << all[i].label << " and " << all[k].label << ", sight " << sight;
                }
        }
    EXPECT_GE(pairs, 100);
}

} // namespace
} // namespace shadowlab::picture

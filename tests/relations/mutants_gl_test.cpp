// Would the relations find a fault? Eight that programs have had, put in on purpose, and the relations that turn red.
// SPDX-License-Identifier: MIT
#include <iostream>
#include <set>

#include "tests/relations/painters_fixture.h"
#include "tests/relations/random_recipes.h"
#include "tests/relations/relation.h"
#include "tests/support/other_shaders.h"

namespace shadowlab::relations {
namespace {

struct Mutant {
    const char* name;
    const char* technique;
    std::vector<std::string> settings;
    Painter::Fault fault;
    std::string shaders;           ///< folder of changed ones below tests/relations/mutants; none: those of the program
    std::set<std::string> foundBy; ///< at least by these
};

void turnAllLights(scene::Scene& scene) {
    for (scene::Light& light : scene.lights) {
        light.type = scene::LightType::directional;
        light.directionWorld = glm::normalize(dvec3(-0.3, -1, -0.2));
        light.intensity = 0.5;
    }
}
void measureFromTheOrigin(scene::Scene& scene) {
    for (scene::Light& light : scene.lights) {
        if (light.type == scene::LightType::directional) continue;
        light.type = scene::LightType::directional;
        light.directionWorld = -glm::normalize(light.positionWorld);
        light.intensity = 0.5;
    }
}
/// What is left when the sides of all triangles are extruded, and each edge's two sides cancel.
void castNothing(scene::Scene& scene) {
    for (scene::Object& object : scene.objects)
        object.castsShadow = false;
}
void dropCastersBesideTheOrigin(scene::Scene& scene) {
    for (scene::Object& object : scene.objects)
        if (scene::boundsWorld(object).lowerWorld.x > 0) object.castsShadow = false;
}

std::vector<Mutant> mutants() {
    return {
        {"bias in metres, not in texels",
         "shadow-map",
         {"bias-mode=constant", "bias-unit=metres", "constant-bias=0.02"},
         {},
         {},
         {"scaled-by-powers-of-two"}},
        {"kernel beside its texel", "shadow-map", {}, {}, "lopsided_kernel", {"in-a-mirror"}},
        // The stencil sticks at zero, where counting down comes before counting up.
        {"count that does not wrap, z-fail",
         "shadow-volume-zfail",
         {"wrap=false", "counter=stencil"},
         {},
         {},
         {"as-rays-say"}},
        {"count that does not wrap, z-pass",
         "shadow-volume-zpass",
         {"wrap=false", "counter=stencil"},
         {},
         {},
         {"as-rays-say"}},
        {"far plane that cuts volumes",
         "shadow-volume-zfail",
         {"far-plane=clip", "volume-end=infinity"},
         {},
         {},
         {"as-rays-say"}},
        {"one direction for all lights",
         "shadow-volume-zfail",
         {},
         turnAllLights,
         {},
         {"turned-by-right-angles", "turned-by-any-angle", "in-a-mirror", "as-rays-say"}},
        {"light measured from the origin",
         "shadow-volume-zfail",
         {},
         measureFromTheOrigin,
         {},
         {"moved", "as-rays-say"}},
        // Wherever everything goes, there is no shadow there either: only rays tell.
        {"volumes that cancel", "shadow-volume-zfail", {}, castNothing, {}, {"as-rays-say"}},
        {"casters dropped by their place in the world",
         "shadow-volume-zfail",
         {},
         dropCastersBesideTheOrigin,
         {},
         {"moved", "turned-by-right-angles", "turned-by-any-angle", "in-a-mirror", "as-rays-say"}},
    };
}

// Enough for every mutant to meet a scene that shows it; one that is found needs no more.
constexpr int kRecipes = 6;
constexpr std::uint64_t kSeed = 4;

/// The relations that do not hold, of those that two pictures of one scene can break.
std::set<std::string> broken(Painter& painter, const Traits& traits, const std::vector<Recipe>& recipes) {
    std::set<std::string> red;
    for (const auto& some : {motionRelations(), casterRelations()})
        for (const Relation& relation : some) {
            if (relation.appliesTo && !relation.appliesTo(traits)) continue;
            for (const Recipe& recipe : recipes)
                if (!complaint(relation.check(recipe, painter), traits).empty()) {
                    red.emplace(relation.id);
                    break;
                }
        }
    return red;
}

class MutantTest : public PaintersTest {};

TEST_F(MutantTest, EachIsFoundAndTheTechniquesAsTheyAreAreNot) {
    const std::vector<Recipe> recipes = randomRecipes(kSeed, kRecipes);
    std::set<std::string> asTheyAre;
    int found = 0;
    for (const Mutant& mutant : mutants()) {
        // What it is meant to be decides which relations it has to hold.
        Painter& right = *painters().at(mutant.technique);
        const Traits traits = right.traits();
        if (asTheyAre.insert(mutant.technique).second) {
            EXPECT_EQ(broken(right, traits, recipes), std::set<std::string>{}) << mutant.technique;
        }
        const testing::OtherShaders shaders(mutant.shaders.empty() ? "" : "relations/mutants/" + mutant.shaders);
        Painter painter(mutant.technique, mutant.settings, mutant.fault);
        const std::set<std::string> red = broken(painter, traits, recipes);
        std::cout << mutant.name << ":";
        for (const std::string& relation : red)
            std::cout << " " << relation;
        std::cout << "\n";
        for (const std::string& relation : mutant.foundBy)
            EXPECT_TRUE(red.contains(relation)) << mutant.name << " is not found by " << relation;
        found += !red.empty();
    }
    EXPECT_EQ(found, static_cast<int>(mutants().size()));
}

} // namespace
} // namespace shadowlab::relations

// Mistakes that make all of a picture alike, or turn light into shadow everywhere.
// SPDX-License-Identifier: MIT
#include "app/foreign/causes.h"
#include "app/picture/verdict_reasons.h"

namespace shadowlab::foreign {

namespace {

void addWhole(const Evidence& evidence, Cause cause, std::vector<Cause>& causes) {
    cause.isOfPicture = true;
    addIfExplains(evidence, std::move(cause), causes);
}

} // namespace

void addWholeCauses(const Evidence& evidence, std::vector<Cause>& causes) {
    const auto facing = [&](const Sample& sample) { return facesTheLight(evidence.truth.visibility[sample.index]); };
    double lit = 0, dark = 0;
    for (const Sample& sample : evidence.samples)
        if (facing(sample)) (sample.isLit ? lit : dark) += sample.weight;
    Cause inverted{"inverted", "", "write 255 where the light is seen and 0 where it is not", {}};
    inverted.predictions = predictAll(evidence, [&](const Sample& sample) { return facing(sample) ? predicted(!sample.shouldBeLit) : Prediction::none; });
    inverted.what = "light and shadow are exchanged: " + percentText(explained(evidence, inverted.predictions)) + " of the wrong pixels are the opposite of the truth everywhere";
    // A picture that is all of one kind is not inverted.
    if (lit > 0 && dark > 0) addWhole(evidence, std::move(inverted), causes);

    constexpr double kSeenPlainly = 1.05; // whatever else predicts it
    constexpr double kOfDescriptions = 0.9; // what predicts the same and says why goes before
    constexpr double kNearlyNone = 0.002; // of all pixels that face the light
    if (dark < kNearlyNone * (lit + dark)) {
        Cause none{"no-shadows", (dark > 0 ? "hardly any shadow is drawn: " + picture::fixed(100 * lit / (lit + dark), 2) + " %" : "no shadow is drawn at all: all") + " of what faces the light is lit",
                   "see that casters are drawn into the map or the volumes, that counts are not all negative (wrong winding, or a test that never fails)", {}};
        if (dark == 0) none.likelihood = kSeenPlainly; // the little that is dark may be all that one caster shades
        none.predictions = predictAll(evidence, [&](const Sample& sample) { return predicted(facing(sample)); });
        addWhole(evidence, std::move(none), causes);
    }
    if (lit < kNearlyNone * (lit + dark)) {
        Cause all{"all-dark", "everything is in shadow: nothing that faces the light is lit",
                  "see whether the light's direction or the normals are negated, a matrix is transposed, depth is compared with a distance, every surface shadows itself, or visibility is written as 0 and 1 instead of 0 and 255", {}};
        all.likelihood = kOfDescriptions;
        all.predictions = predictAll(evidence, [&](const Sample&) { return Prediction::dark; });
        addWhole(evidence, std::move(all), causes);
    }
}

} // namespace shadowlab::foreign

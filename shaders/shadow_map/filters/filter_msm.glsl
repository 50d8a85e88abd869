// Moment shadow maps: with the means of z, z^2, z^3 and z^4, two depths are known exactly, and of more the least share that
// is before the receiver. That is Hamburger's moment problem: of all distributions with these moments, the one that has
// the least before d puts all its weight on three depths, one of them d itself. Peters and Klein, "Moment Shadow Mapping",
// I3D 2015, who solve it in a few lines; so do these, in the order of the proof.
#include "shadow_map/moments/moments.glsl"
#include "shadow_map/moments/chebyshev.glsl"
uniform float msmBias;

// The share of light at depth d: 1 less the weights of the depths before it.
float hamburgerVisibility(vec4 m, float d) {
    // The matrix of moments, rows (1, m1, m2), (m1, m2, m3), (m2, m3, m4), is L D transpose(L).
    float d2 = m.y - m.x * m.x; // variance
    float l32 = (m.z - m.x * m.y) / d2;
    float d3 = m.w - m.y * m.y - l32 * l32 * d2;
    // Solve it for (1, d, d^2): the coefficients of the polynomial that vanishes at the other two depths.
    vec3 c = vec3(1.0, d - m.x, 0.0);
    c.z = (d * d - m.y - l32 * c.y) / d3;
    c.y = c.y / d2 - l32 * c.z;
    c.x -= dot(vec2(m.x, m.y), c.yz);
    // c.z is nearly 0 where one of them is far away, and has no weight. Then -p +- sqrt(p^2 - q) would lose all digits of the
    // other one; sums of numbers of one sign lose none.
    float sum = c.y + (c.y < 0.0 ? -1.0 : 1.0) * sqrt(max(c.y * c.y - 4.0 * c.z * c.x, 0.0));
    float one = clamp(-0.5 * sum / c.z, -1e6, 1e6), other = -2.0 * c.x / sum;
    float nearer = min(one, other), farther = max(one, other);
    if (d <= nearer) return 1.0;
    // The weight of one of three depths follows from mean and mean square alone (Lagrange).
    float weightNearer = (m.y - m.x * (d + farther) + d * farther) / ((nearer - d) * (nearer - farther));
    if (d <= farther) return 1.0 - clamp(weightNearer, 0.0, 1.0);
    float weightOfPoint = (m.y - m.x * (nearer + farther) + nearer * farther) / ((d - nearer) * (d - farther));
    return clamp(weightOfPoint, 0.0, 1.0);
}

// [anchor: compare-msm]
float filteredVisibility(MapPlace place) {
    if (isOutside(place)) return 1.0;
    // Rounding may leave moments that no depths can have. Mixing in a little of the moments of three depths, -1, 0 and 1, is the remedy.
    // Peters, Muenstermann, Wetzstein and Klein, "Improved Moment Shadow Maps", JCGT 6(1), 2017.
    vec4 m = mix(momentsAt(place), vec4(0.0, 0.375, 0.0, 0.375), msmBias);
    // The part that was mixed in may count as lit, and the bound holds for the rest: so a fully lit point gets exactly 1.
    return withoutBleeding(hamburgerVisibility(m, receiverMomentDepth(place)) / (1.0 - msmBias));
}

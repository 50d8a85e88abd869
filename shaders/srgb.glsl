// IEC 61966-2-1: 12.92 c for dark colours, 1.055 c^(1/2.4) - 0.055 for all others. That power is t^(5/3) of the fourth root t,
// smooth enough for a polynomial (minimax, found by Remez' exchange) that is never off by more than a 2800th of a byte's step.
// Where there is no graphics card a power costs three times as much, in every pixel of every frame.
vec3 srgbFromLinear(vec3 color) {
    vec3 t = sqrt(sqrt(color));
    vec3 bright = vec3(0.068207979);
    bright = bright * t - 0.318415992;
    bright = bright * t + 0.657188290;
    bright = bright * t - 0.852957453;
    bright = bright * t + 1.365921050;
    bright = bright * t + 0.139604136;
    bright = bright * t - 0.059546609;
    return mix(12.92 * color, bright, greaterThan(color, vec3(0.0031308)));
}

// IEC 61966-2-1: 12.92 c for dark colours, 1.055 c^(1/2.4) - 0.055 for all others. That power is s^(5/6) of the square root s,
// smooth enough for a polynomial (minimax, found by Remez' exchange) that is never off by more than a 20th of a byte's step.
// Below 0.0031308, where both meet, the polynomial is the smaller of the two, and above it the other one is held at 0.0404: so
// the larger one is right, and nothing is chosen pixel by pixel. Where there is no graphics card a power costs three times as
// much as this, and a choice as much as the polynomial, in every pixel of every frame.
vec3 srgbFromLinear(vec3 color) {
    vec3 s = sqrt(color);
    vec3 bright = vec3(-0.947672461);
    bright = bright * s + 3.41869043;
    bright = bright * s - 5.00317298;
    bright = bright * s + 3.89844441;
    bright = bright * s - 1.89947746;
    bright = bright * s + 1.57527103;
    bright = bright * s - 0.0422319578;
    return max(bright, min(12.92 * color, 0.0404));
}

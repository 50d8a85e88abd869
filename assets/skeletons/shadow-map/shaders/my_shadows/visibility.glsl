// Does the light see this point? Asked of the map.
in vec4 positionLightClip; // the point, in the clip space of the light's camera
uniform sampler2DArray depthMap; // d(u,v): depth of the first surface; 1 where there is none, and beyond the map's border

float shadowVisibility() {
    // === BLANK 4: the way into the map. Clip space is homogeneous: x, y and z become coordinates by the division by w, from -1 to
    // 1, and (s, t, r) go from 0 to 1. What lies behind the lamp has w <= 0, and is in no map: no caster stands between, so return
    // 1.0. As it is, every point lies beyond the border. When it is right, shadows lie where they belong.
    vec3 str = vec3(-1.0);
    // === END OF BLANK 4
    float z = min(str.z, 1.0); // what is farther away than every caster is in no map either
    float d = texture(depthMap, vec3(str.xy, 0.0)).r;
    // === BLANK 5: the comparison. The point is lit if nothing is nearer to the light than itself. When it is right, and the bias is
    // missing, half of every lit surface is dark: look at that once before you fill in blank 3.
    return 1.0;
    // === END OF BLANK 5
}

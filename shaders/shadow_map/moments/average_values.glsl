// The mean of some vectors, one after the other.
struct Average {
    vec4 sum;
    float count;
};

Average emptyAverage() { return Average(vec4(0.0), 0.0); }

void add(inout Average average, vec4 v) {
    average.sum += v;
    average.count += 1.0;
}

vec4 meanOf(Average average) { return average.sum / average.count; }

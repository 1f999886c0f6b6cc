#include "patch/mend.h"
#include "patch/strain.h"

/* Arms shorter or longer than these shares of the chord make cusps and loops. */
#define SHORTEST_ARM 0.05
#define LONGEST_ARM 1.2

/* Places tried to both sides of the nearest on the line of equal angles; along it, as a share of
 * the chord; and steps towards the plane, of which the last would be the plane itself. */
enum { PLACES = 30, TWISTS = 10, WAYS = 32, HALVINGS = 20 };
#define STEP 0.02

bool kg_patch_is_sound(const kg_patch_input *input) {
    kg_patch p;
    return !kg_patch_init(input, &p, NULL) && !p.clamped && p.theta[0] >= KG_FLAT_RULING &&
           p.theta[1] <= KG_PI - KG_FLAT_RULING;
}

static bool is_easy(const kg_patch_input *in) {
    return kg_strain_is_easy(kg_cubic_strain(in->points, in->extent)) && kg_patch_is_sound(in);
}

/* The place `along` mm from the nearest on the line of equal angles; false when it has none. */
static bool place_arms(kg_patch_input *in, double along) {
    kg_vec3 *p = in->points, chord = kg_sub(p[3], p[0]);
    kg_vec3 t0 = kg_unit(kg_sub(p[1], p[0])), t1 = kg_unit(kg_sub(p[3], p[2]));
    double difference = kg_dot(kg_sub(t0, t1), chord) / (1 - kg_dot(t0, t1));
    double sum = kg_dist(p[0], p[1]) + kg_dist(p[2], p[3]) + 2 * along;
    double a = 0.5 * (sum + difference), b = 0.5 * (sum - difference), size = kg_len(chord);
    if (!(fmin(a, b) >= SHORTEST_ARM * size && fmax(a, b) <= LONGEST_ARM * size))
        return false;
    p[1] = kg_madd(p[0], a, t0);
    p[2] = kg_madd(p[3], -b, t1);
    return true;
}

static bool find_place(const kg_patch_input *from, kg_patch_input *out) {
    double size = kg_dist(from->points[0], from->points[3]);
    for (int i = 0; i <= 2 * PLACES; i++) {
        double along = STEP * size * (i % 2 ? (i + 1) / 2 : -(i / 2));
        kg_patch_input in = *from;
        if (place_arms(&in, along) && is_easy(&in)) {
            *out = in;
            return true;
        }
    }
    return false;
}

static kg_patch_input between(const kg_patch_input *a, const kg_patch_input *b, double f) {
    kg_patch_input in = *a;
    for (size_t i = 0; i < in.point_count; i++)
        in.points[i] = kg_lerp(a->points[i], b->points[i], f);
    return in;
}

kg_status kg_patch_equalize(const kg_patch_input *input, kg_patch_input *out, kg_error *error) {
    kg_curve curve;
    kg_patch_input flat, even;
    if (input->point_count != 4)
        return kg_fail(error, KG_ERR_INPUT,
                       "has six control points: only cubics have turning angles to make equal; "
                       "flatten it or split it");
    kg_status status = kg_curve_init(input->points, 4, &curve, error);
    if (!status)
        status = kg_patch_flatten(input, &flat, error);
    if (status)
        return status;
    if (kg_curve_classify(&curve) != KG_CURVE_SPATIAL)
        return kg_fail(error, KG_ERR_INPUT, "lies in a plane: its rulings are parallel already");
    bool sound = is_easy(input), found = false;
    for (int i = 0; i < (sound ? 1 : TWISTS) && !found; i++) {
        kg_patch_input start = between(input, &flat, (double)i / TWISTS);
        found = find_place(&start, &even);
    }
    if (!found)
        return kg_fail(error, KG_ERR_INPUT,
                       "has no sound shape with equal end angles: it bends both ways, or too "
                       "sharply for its extent; split it, flatten it or narrow the extent");
    /* the first of some steps that is sound, and from there back to where it begins to be */
    double lo = 0, hi = 1;
    for (int i = 1; i < WAYS && !sound; i++) {
        kg_patch_input in = between(input, &even, (double)i / WAYS);
        if (is_easy(&in)) {
            hi = (double)i / WAYS;
            lo = (i - 1.0) / WAYS;
            break;
        }
    }
    for (int i = 0; i < HALVINGS && !sound; i++) {
        double middle = 0.5 * (lo + hi);
        kg_patch_input in = between(input, &even, middle);
        *(is_easy(&in) ? &hi : &lo) = middle;
    }
    *out = between(input, &even, hi);
    return KG_OK;
}

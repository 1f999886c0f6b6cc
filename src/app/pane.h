/* The 3D view: a camera and the part of the window it fills. */
#ifndef KG_APP_PANE_H
#define KG_APP_PANE_H

#include "app/event.h"
#include "app/ui/ui.h"

typedef enum kg_navigation { KG_NAVIGATION_DEFAULT, KG_NAVIGATION_BLENDER } kg_navigation;

typedef enum kg_pane_drag { KG_DRAG_NONE, KG_DRAG_ORBIT, KG_DRAG_PAN, KG_DRAG_ZOOM } kg_pane_drag;

typedef struct kg_pane {
    kg_camera camera;
    kg_area area;
    double scale; /* pixels per layout unit */
    kg_pane_drag drag;
    int button; /* that drags */
    kg_vec2 pressed, last;
    bool moved;   /* farther than a click may */
    kg_vec2 size; /* of the area, when it was last kept in frame */
    kg_box3 framed;
    kg_camera fitted; /* as that left it; panned or zoomed since, the box is framed no more */
} kg_pane;

/* A press that moves less is a click; layout units. */
#define KG_CLICK_DISTANCE 5

/* Where a point is seen in the window; false behind the eye. */
bool kg_pane_project(const kg_pane *pane, kg_vec3 point, kg_vec2 *out_px);
void kg_pane_ray(const kg_pane *pane, kg_vec2 px, kg_vec3 *out_origin, kg_vec3 *out_direction);
/* The point under `px` in the plane through `through` that faces the camera. */
kg_vec3 kg_pane_on_screen_plane(const kg_pane *pane, kg_vec2 px, kg_vec3 through);
/* The point under `px` in any plane; false when it is seen edge-on or lies behind. */
bool kg_pane_on_plane(const kg_pane *pane, kg_vec2 px, kg_vec3 through, kg_vec3 normal,
                      kg_vec3 *out_point);
/* How far along an axis (of length 1) through a point the place nearest to the line of sight is,
 * mm; false when the axis is seen end-on. */
bool kg_pane_along_axis(const kg_pane *pane, kg_vec2 px, kg_vec3 through, kg_vec3 axis,
                        double *out_mm);
/* How far a point is from the segment from a to b, and (`out_fraction`, may be NULL) where on it
 * the nearest point lies, in [0, 1]. */
double kg_segment_distance(kg_vec2 p, kg_vec2 a, kg_vec2 b, double *out_fraction);

/* Keeps the `most` nearest hits along a ray, nearest first, earlier ones before others as far;
 * returns how many there are now. A hit is a struct of `size` bytes that begins with its distance,
 * a double.
 */
size_t kg_hits_keep(void *hits, size_t count, size_t most, const void *hit, size_t size);
/* Size of a pixel at a point, mm. */
double kg_pane_pixel_mm(const kg_pane *pane, kg_vec3 point);

/* Orbit, pan and zoom by the mouse. True: the event is used up. A press of the right button that
 * did not move is not (its release opens the context menu). */
bool kg_pane_event(kg_pane *pane, const kg_event *event, kg_navigation navigation);

void kg_pane_fit(kg_pane *pane, kg_box3 box);
/* To be called when the area may have another size: what was fitted stays in frame, whichever way
 * it was turned since; after panning or zooming only the middle stays. */
void kg_pane_keep_frame(kg_pane *pane);

#endif

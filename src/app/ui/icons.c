#include "app/ui/icons.h"

/* Icons are drawn in a square of 16 × 16 with lines of 1.4. */
typedef struct pen {
    kg_area area;
    kg_color color;
    double unit;
} pen;

static kg_vec2 at(const pen *p, double x, double y) {
    return kg_v2(p->area.x + x * p->unit, p->area.y + y * p->unit);
}

static void line(const pen *p, double x0, double y0, double x1, double y1) {
    kg_ui_canvas_line(at(p, x0, y0), at(p, x1, y1), p->color, 1.4 * p->unit);
}

static void path(const pen *p, const double (*xy)[2], size_t count, bool closed) {
    kg_vec2 points[12];
    for (size_t i = 0; i < count; i++)
        points[i] = at(p, xy[i][0], xy[i][1]);
    kg_ui_canvas_polyline(points, count, closed, p->color, 1.4 * p->unit);
}
#define PATH(p, closed, ...)                                                                       \
    path((p), (const double[][2]){__VA_ARGS__},                                                    \
         sizeof(double[][2]){__VA_ARGS__} / sizeof(double[2]), (closed))

static void ring(const pen *p, double x, double y, double r) {
    kg_ui_canvas_circle(at(p, x, y), r * p->unit, p->color, 1.4 * p->unit);
}

static void dot(const pen *p, double x, double y, double r) {
    kg_ui_canvas_disc(at(p, x, y), r * p->unit, p->color);
}

static void arrow_head(const pen *p, double x, double y, double dx, double dy) {
    kg_vec2 tip[3] = {at(p, x + 3 * dx, y + 3 * dy), at(p, x - 2 * dy, y + 2 * dx),
                      at(p, x + 2 * dy, y - 2 * dx)};
    kg_ui_canvas_polygon(tip, 3, p->color);
}

static void eye(const pen *p) {
    PATH(p, true, {1.5, 8}, {4, 5.2}, {8, 4}, {12, 5.2}, {14.5, 8}, {12, 10.8}, {8, 12}, {4, 10.8});
    dot(p, 8, 8, 2.2);
}

/* Triangles to the right or to the left (`way` -1) from x on. */
static void wedge(const pen *p, double x, double way) {
    kg_vec2 corners[3] = {at(p, x, 3.5), at(p, x + 7 * way, 8), at(p, x, 12.5)};
    kg_ui_canvas_polygon(corners, 3, p->color);
}

static void player_icon(const pen *p, kg_icon icon) {
    switch (icon) {
    case KG_ICON_PLAY:
        wedge(p, 5, 1);
        break;
    case KG_ICON_STOP:
        line(p, 5.5, 3.5, 5.5, 12.5), line(p, 10.5, 3.5, 10.5, 12.5);
        break;
    case KG_ICON_FIRST:
        wedge(p, 12, -1), line(p, 4, 3.5, 4, 12.5);
        break;
    case KG_ICON_PREVIOUS:
        PATH(p, false, {10, 3.5}, {5.5, 8}, {10, 12.5});
        break;
    case KG_ICON_NEXT:
        PATH(p, false, {6, 3.5}, {10.5, 8}, {6, 12.5});
        break;
    default:
        wedge(p, 4, 1), line(p, 12, 3.5, 12, 12.5);
        break;
    }
}

static void tool_icon(const pen *p, kg_icon icon) {
    switch (icon) {
    case KG_ICON_SELECT:
        PATH(p, true, {4, 2}, {4, 13}, {7, 10.5}, {9, 14.5}, {10.8, 13.6}, {9, 9.8}, {12.5, 9.4});
        break;
    case KG_ICON_PLACE:
        PATH(p, false, {2, 12}, {4, 8}, {7, 5.5}, {11, 4.5}, {14, 5});
        dot(p, 2, 12, 1.7), dot(p, 5.2, 6.8, 1.7), dot(p, 10, 4.6, 1.7), dot(p, 14, 5, 1.7);
        line(p, 12, 9, 12, 14), line(p, 9.5, 11.5, 14.5, 11.5);
        break;
    case KG_ICON_MOVE:
        line(p, 8, 3, 8, 13), line(p, 3, 8, 13, 8);
        arrow_head(p, 8, 3, 0, -0.8), arrow_head(p, 8, 13, 0, 0.8);
        arrow_head(p, 3, 8, -0.8, 0), arrow_head(p, 13, 8, 0.8, 0);
        break;
    case KG_ICON_ROTATE:
        PATH(p, false, {12.5, 5}, {10, 3.2}, {7, 3.2}, {4.2, 5}, {3.2, 8}, {4.2, 11}, {7, 12.8},
             {10, 12.8}, {12.3, 11});
        arrow_head(p, 12.6, 4.8, 0.6, 0.7);
        break;
    case KG_ICON_SCALE:
        PATH(p, true, {2, 9}, {7, 9}, {7, 14}, {2, 14});
        line(p, 8, 8, 12.5, 3.5), arrow_head(p, 12, 4, 0.7, -0.7);
        break;
    case KG_ICON_TRIM:
        ring(p, 4, 12, 2.2), ring(p, 12, 12, 2.2);
        line(p, 5.4, 10.4, 11.5, 2), line(p, 10.6, 10.4, 4.5, 2);
        break;
    case KG_ICON_CONTOUR:
        PATH(p, true, {2.5, 10}, {5, 3}, {9, 6}, {13.5, 4.5}, {12.5, 12.5}, {7, 11.5});
        break;
    default:
        PATH(p, true, {2, 13}, {6.2, 13}, {6.2, 3});
        PATH(p, true, {14, 13}, {9.8, 13}, {9.8, 3});
        line(p, 8, 1.5, 8, 14.5);
        break;
    }
}

/* A line of dashes. */
static void dashes(const pen *p, double x0, double y0, double x1, double y1) {
    for (int i = 0; i < 3; i++) {
        double a = 0.36 * i, b = a + 0.24;
        line(p, x0 + a * (x1 - x0), y0 + a * (y1 - y0), x0 + b * (x1 - x0), y0 + b * (y1 - y0));
    }
}

static void fold_icon(const pen *p, kg_icon icon) {
    switch (icon) {
    case KG_ICON_FOLD_CORNER:
        PATH(p, true, {2, 2}, {9, 2}, {14, 7}, {14, 14}, {2, 14});
        PATH(p, false, {9, 2}, {9, 7}, {14, 7});
        break;
    case KG_ICON_FOLD_AXIS:
        PATH(p, true, {2.5, 2.5}, {13.5, 2.5}, {13.5, 13.5}, {2.5, 13.5});
        dashes(p, 4, 15, 12, 1);
        dot(p, 5.2, 12.8, 1.6), dot(p, 10.8, 3.2, 1.6);
        break;
    case KG_ICON_FOLD_BISECT:
        line(p, 2, 13.5, 14.5, 13.5), line(p, 2, 13.5, 9, 2);
        dashes(p, 2, 13.5, 13, 6.5);
        break;
    case KG_ICON_FOLD_SQUARE:
        line(p, 1.5, 13, 14.5, 13);
        dashes(p, 8, 13, 8, 1);
        PATH(p, false, {8, 9.8}, {11.2, 9.8}, {11.2, 13});
        break;
    case KG_ICON_MOUNTAIN:
        PATH(p, false, {1.5, 12.5}, {8, 4}, {14.5, 12.5});
        break;
    default:
        PATH(p, false, {1.5, 4}, {8, 12.5}, {14.5, 4});
        break;
    }
}

/* A cube, with its upper face and two sides. */
static void cube(const pen *p, double x, double y, double r) {
    PATH(p, true, {x, y - r}, {x + 0.87 * r, y - r / 2}, {x + 0.87 * r, y + r / 2}, {x, y + r},
         {x - 0.87 * r, y + r / 2}, {x - 0.87 * r, y - r / 2});
    PATH(p, false, {x - 0.87 * r, y - r / 2}, {x, y}, {x + 0.87 * r, y - r / 2});
    line(p, x, y, x, y + r);
}

static void card_icon(const pen *p, kg_icon icon) {
    switch (icon) {
    case KG_ICON_VOXEL_ADD:
    case KG_ICON_VOXEL_REMOVE:
        cube(p, 6.5, 9, 5.5);
        line(p, 10.5, 3.5, 15.5, 3.5);
        if (icon == KG_ICON_VOXEL_ADD)
            line(p, 13, 1, 13, 6);
        break;
    case KG_ICON_PULL:
        PATH(p, true, {2, 5}, {7, 2.5}, {7, 11}, {2, 13.5});
        line(p, 7, 7, 12, 9), arrow_head(p, 12, 9, 0.9, 0.4);
        break;
    case KG_ICON_WINDOW:
        PATH(p, true, {2.5, 2}, {13.5, 2}, {13.5, 14}, {2.5, 14});
        PATH(p, true, {5.5, 5}, {10.5, 5}, {10.5, 11}, {5.5, 11});
        line(p, 8, 5, 8, 11), line(p, 5.5, 8, 10.5, 8);
        break;
    case KG_ICON_TOP:
        PATH(p, false, {2.5, 5.5}, {2.5, 12}, {8, 15}, {13.5, 12}, {13.5, 5.5});
        line(p, 8, 9, 8, 15), line(p, 2.5, 5.5, 8, 9), line(p, 13.5, 5.5, 8, 9);
        for (int i = 0; i < 2; i++)
            line(p, 3.5 + 3 * i, 4.9 - 1.6 * i, 5 + 3 * i, 4.1 - 1.6 * i),
                line(p, 12.5 - 3 * i, 4.9 - 1.6 * i, 11 - 3 * i, 4.1 - 1.6 * i);
        break;
    case KG_ICON_PLANE_UPRIGHT:
        PATH(p, true, {3, 4}, {13, 1.5}, {13, 12}, {3, 14.5});
        line(p, 8, 2.8, 8, 13.2), line(p, 3, 9.2, 13, 6.8);
        break;
    default:
        PATH(p, true, {1.5, 9}, {8, 5}, {14.5, 9}, {8, 13});
        line(p, 4.8, 7, 11.2, 11), line(p, 11.2, 7, 4.8, 11);
        break;
    }
}

void kg_icon_draw(kg_icon icon, kg_area area, kg_color color) {
    double side = 0.8 * (area.width < area.height ? area.width : area.height);
    pen p = {{area.x + (area.width - side) / 2, area.y + (area.height - side) / 2, side, side},
             color,
             side / 16};
    switch (icon) {
    case KG_ICON_EYE:
        eye(&p);
        break;
    case KG_ICON_EYE_OFF:
        p.color.a *= 0.45F;
        eye(&p);
        line(&p, 3, 13.5, 13, 2.5);
        break;
    case KG_ICON_FLIP:
        PATH(&p, false, {3, 6}, {3, 4}, {12, 4});
        PATH(&p, false, {13, 10}, {13, 12}, {4, 12});
        arrow_head(&p, 12, 4, 0.8, 0), arrow_head(&p, 4, 12, -0.8, 0);
        break;
    case KG_ICON_UP:
        PATH(&p, false, {4, 10}, {8, 6}, {12, 10});
        break;
    case KG_ICON_DOWN:
        PATH(&p, false, {4, 6}, {8, 10}, {12, 6});
        break;
    case KG_ICON_REMOVE:
        line(&p, 4, 4, 12, 12), line(&p, 12, 4, 4, 12);
        break;
    case KG_ICON_GUIDE:
        for (int i = 0; i < 3; i++)
            line(&p, 2 + 4.5 * i, 12.5 - 3.5 * i, 5 + 4.5 * i, 10.2 - 3.5 * i);
        break;
    case KG_ICON_WARNING:
        PATH(&p, true, {8, 2.5}, {14.5, 13.5}, {1.5, 13.5});
        line(&p, 8, 6.5, 8, 10), dot(&p, 8, 11.8, 0.9);
        break;
    case KG_ICON_FOLDER:
        PATH(&p, true, {2, 4}, {6, 4}, {7.5, 5.5}, {14, 5.5}, {14, 13}, {2, 13});
        break;
    case KG_ICON_FILE:
        PATH(&p, true, {4, 2}, {9.5, 2}, {12.5, 5}, {12.5, 14}, {4, 14});
        break;
    case KG_ICON_ADD:
        line(&p, 8, 3, 8, 13), line(&p, 3, 8, 13, 8);
        break;
    case KG_ICON_COPY:
        PATH(&p, true, {2.5, 5.5}, {10, 5.5}, {10, 13.5}, {2.5, 13.5});
        PATH(&p, false, {5.5, 2.5}, {13, 2.5}, {13, 11});
        break;
    case KG_ICON_PLAY:
    case KG_ICON_STOP:
    case KG_ICON_FIRST:
    case KG_ICON_PREVIOUS:
    case KG_ICON_NEXT:
    case KG_ICON_LAST:
        player_icon(&p, icon);
        break;
    case KG_ICON_FOLD_CORNER:
    case KG_ICON_FOLD_AXIS:
    case KG_ICON_FOLD_BISECT:
    case KG_ICON_FOLD_SQUARE:
    case KG_ICON_MOUNTAIN:
    case KG_ICON_VALLEY:
        fold_icon(&p, icon);
        break;
    case KG_ICON_CHECK:
        PATH(&p, false, {2.5, 8.5}, {6.5, 12.5}, {13.5, 4});
        break;
    case KG_ICON_VOXEL_ADD:
    case KG_ICON_VOXEL_REMOVE:
    case KG_ICON_PULL:
    case KG_ICON_WINDOW:
    case KG_ICON_TOP:
    case KG_ICON_PLANE_UPRIGHT:
    case KG_ICON_PLANE_LEVEL:
        card_icon(&p, icon);
        break;
    default:
        tool_icon(&p, icon);
        break;
    }
}

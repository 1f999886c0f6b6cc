/* The taken cells of one page, kept so that a shape jumps over what it runs into. */
#ifndef KG_NET_NEST_PAGE_H
#define KG_NET_NEST_PAGE_H

#include "net/nest_raster.h"

typedef struct kg_nest_page {
    int width, height;  /* cells, at most INT16_MAX */
    int16_t *taken;     /* per cell: the last taken cell of its row up to it, or -1 */
    int16_t *free_from; /* per cell: the first free cell of its row from it on, or `width` */
} kg_nest_page;

kg_status kg_nest_page_create(int width, int height, kg_nest_page *out) KG_CHECKED;
void kg_nest_page_destroy(kg_nest_page *page);

void kg_nest_page_clear(kg_nest_page *page);
void kg_nest_page_copy(kg_nest_page *to, const kg_nest_page *from);

/* Takes the raster's cells, moved by (x, y); cells outside the page are passed over. */
void kg_nest_page_take(kg_nest_page *page, const kg_nest_raster *raster, int x, int y);

/* The first position, by y then x, with 0 <= x <= x_max and 0 <= y <= y_max where no cell of the
 * raster is taken. *work grows by the number of runs looked at. */
bool kg_nest_page_find(const kg_nest_page *page, const kg_nest_raster *raster, int x_max, int y_max,
                       int *out_x, int *out_y, uint64_t *work);

#endif

/* Crossings made ready to cut: as chains, clipped, prolonged and joined. */
#ifndef KG_TRIM_CUTTING_H
#define KG_TRIM_CUTTING_H

#include "trim/arrangement.h"

kg_status kg_trim_note_add(const kg_trim *trim, kg_trim_note note) KG_CHECKED;

/* The branches of a cut as chains, only the stretches in the cutter's regions if it is bounded. */
kg_status kg_cut_chains(const kg_patch *patch, const kg_cut *cut, kg_chains *chains) KG_CHECKED;

/* Prolongs chains[first …] that end inside the region, in (u,v) along the end tangent, to the next
 * chain. */
kg_status kg_cut_prolong(const kg_trim *trim, const kg_region *region, size_t first,
                         kg_chains *chains) KG_CHECKED;

/* Joins loose ends of chains[first …]: each to the nearest loose end of another chain, or along
 * its tangent to the next chain where that is nearer. */
kg_status kg_cut_join(const kg_trim *trim, size_t first, kg_chains *chains) KG_CHECKED;

#endif

#include "guide/words.h"

#include "base/phrase.h"

#include <stdarg.h>

/* Formats may be reordered with %2$s and the like; behind each: its values. */
static const char *const words[KG_WORD_COUNT] = {
    [KG_WORD_FOOTER] = N_("%s · assembly guide"), /* title */
    [KG_WORD_UNTITLED] = N_("Paper model"),
    [KG_WORD_GUIDE] = N_("Assembly guide"),
    [KG_WORD_SIZE] = N_("%.0f × %.0f × %.0f mm (width × depth × height)"),
    [KG_WORD_COUNTS] = N_("Parts: %d · pages of the net: %d · joins: %d"),
    [KG_WORD_WORK] = N_("To cut: %.0f cm of line. To glue: %.0f cm. Roughly %s of work."),
    [KG_WORD_HOURS] = N_("%d h %02d min"),
    [KG_WORD_MINUTES] = N_("%d minutes"),
    [KG_WORD_PARTS] = N_("Parts"),
    [KG_WORD_PART] = N_("part %d"),            /* number */
    [KG_WORD_PART_NAMED] = N_("part %d (%s)"), /* number, name */
    [KG_WORD_PAGE] = N_("page %d"),            /* of the net */
    [KG_WORD_AND] = N_("%s %s"),
    [KG_WORD_LEGEND] = N_("Lines and numbers"),
    [KG_WORD_CUT] = N_("Cut along this line."),
    [KG_WORD_MOUNTAIN] =
        N_("Mountain fold: the printed side is outside the fold, the paper bends away from you."),
    [KG_WORD_VALLEY] =
        N_("Valley fold: the printed side is inside the fold, the paper bends towards you."),
    [KG_WORD_MARK] = N_("Mark: another part is glued onto the paper here. Neither cut nor fold."),
    [KG_WORD_TAB] =
        N_("Tab: fold it along its line, put the glue on it. Short teeth follow a bent edge."),
    [KG_WORD_NUMBERS] = N_(
        "Each join has a number in a ring. It is printed at both edges of a seam, or at an edge "
        "and "
        "at the mark it comes to lie on: equal numbers belong together. Numbers in boxes are those "
        "of the parts."),
    [KG_WORD_RULINGS] = N_(
        "Thin lines in the list of parts show around which straight lines a part is rolled. They "
        "are not on the net. Roll before gluing, over the edge of a table or a round stick."),
    [KG_WORD_PICTURES] =
        N_("In the pictures the new part is orange, with its number in a box. The "
           "joins to be glued are "
           "red, with their numbers in rings; dashed arrows show where it goes. What "
           "stands already is "
           "pale, its inside brown."),
    [KG_WORD_GLUING] =
        N_("Score and fold all lines and roll all parts before you glue. Put little glue on a tab, "
           "begin at one end of the join and go on along it."),
    [KG_WORD_SUBASSEMBLY] = N_("Put aside what stands: no join leads from here to it."),
    [KG_WORD_START] = N_("Step %d · Begin with %s"),
    [KG_WORD_OWN] = N_("Step %d · Glue %s to itself"),
    [KG_WORD_ATTACH] = N_("Step %d · Attach %s"),
    [KG_WORD_CLOSE] = N_("Step %d · Close %s"),
    [KG_WORD_PLACE] = N_("Step %d · Place the sub-assembly of %s"),
    [KG_WORD_FLAT] = N_("It stays flat. (Net page %d)"),
    [KG_WORD_ROLL_OUT] = N_("Bend it with the printed side outside, radius %.0f mm where it is "
                            "tightest. (Net page %d)"),
    [KG_WORD_ROLL_IN] = N_(
        "Bend it with the printed side inside, radius %.0f mm where it is tightest. (Net page %d)"),
    [KG_WORD_ROLL_BOTH] =
        N_("Bend it into an S, to both sides, radius %.0f mm where it is tightest. (Net page %d)"),
    [KG_WORD_FOLDS] = N_("Fold it along its %d inner fold lines."),
    [KG_WORD_SEAM] = N_("Seam with %s, %.0f mm."),                      /* part, length */
    [KG_WORD_CONTACT] = N_("Edge of %s onto the mark on %s, %.0f mm."), /* edge, mark, length */
    [KG_WORD_CONTACT_INSIDE] = N_(
        "Edge of %s onto the back of %s, along its mark, %.0f mm. Prick the mark through first."),
    [KG_WORD_OWN_SEAM] = N_("Edge to edge of the same part, %.0f mm."),
    [KG_WORD_TABS_ON] = N_("The tabs are on %s."),
    [KG_WORD_NO_TABS] = N_("No tabs: glue edge to edge."),
    [KG_WORD_CLOSING] = N_(
        "%d is a closing join: it closes a ring. Let the joins before it dry, and reach the tabs "
        "from inside through what is still open."),
    [KG_WORD_SEALS] = N_(
        "%d is the closing seam: afterwards the inside cannot be reached any more. Fold its tabs "
        "a little less than they need, so that they press outwards against the other part; use "
        "slow glue, close it from one end to the other, and press from outside."),
    [KG_WORD_PLACE_TEXT] =
        N_("No join holds this sub-assembly. Place it as the picture shows, with a drop of glue or "
           "beside the rest."),
    [KG_WORD_SHEETS_FOOTER] = N_("%s · folding steps"), /* title */
    [KG_WORD_SHEETS_GUIDE] = N_("Folding steps"),
    [KG_WORD_SHEET_SIZE] = N_("Sheet %d: %.4g × %.4g mm"), /* number, width, height */
    [KG_WORD_SHEETS_COUNTS] = N_("Folds: %d · crease pattern on the last page"),
    [KG_WORD_CREASE_PATTERN] = N_("Crease pattern"),
    [KG_WORD_TO_CORNER] = N_("Fold the corner to the other corner."),
    [KG_WORD_TO_CORNER_BEHIND] = N_("Fold the corner behind, to the other corner."),
    [KG_WORD_EDGE_TO_EDGE] = N_("Fold the edge to the other edge."),
    [KG_WORD_EDGE_TO_EDGE_BEHIND] = N_("Fold the edge behind, to the other edge."),
    [KG_WORD_EDGE_TO_LINE] = N_("Fold the edge to the line that it meets."),
    [KG_WORD_EDGE_TO_LINE_BEHIND] = N_("Fold the edge behind, to the line that it meets."),
    [KG_WORD_TO_EDGE] = N_("Fold the corner to the circled point on the edge."),
    [KG_WORD_TO_EDGE_BEHIND] = N_("Fold the corner behind, to the circled point on the edge."),
    [KG_WORD_TO_POINT] = N_("Fold the corner to the circled point."),
    [KG_WORD_TO_POINT_BEHIND] = N_("Fold the corner behind, to the circled point."),
    [KG_WORD_ALONG_LINE] = N_("Fold along the dashed line."),
    [KG_WORD_ALONG_LINE_BEHIND] = N_("Fold behind along the line."),
    [KG_WORD_BY_ANGLE] = N_("Turn it by %.4g° only."),
    [KG_WORD_LAYERS] = N_("%d layers together."),
    [KG_WORD_TOP_LAYER] = N_("One layer only, of %d."),
    [KG_WORD_TOP_LAYERS] = N_("%d layers together, of %d."),
    [KG_WORD_TUCK] = N_("Tuck it between two layers."),
    [KG_WORD_UNFOLD] = N_("Unfold it again: the crease stays."),
    [KG_WORD_TURN_OVER] = N_("Turn the paper over."),
    [KG_WORD_SEEN_OBLIQUE] = N_("Seen from an angle."),
    [KG_WORD_FINISHED] = N_("The finished model."),
    [KG_WORD_COLLAPSED] = N_("Folded along all its creases."),
    [KG_WORD_LENGTH] = N_("%.6g mm"),
    [KG_WORD_SIGNS] = N_("Lines and signs"),
    [KG_WORD_VALLEY_LINE] = N_("Valley fold: towards you"),
    [KG_WORD_MOUNTAIN_LINE] = N_("Mountain fold: away from you"),
    [KG_WORD_OLD_CREASE] = N_("Crease from an earlier fold"),
    [KG_WORD_VALLEY_ARROW] = N_("Fold in front"),
    [KG_WORD_MOUNTAIN_ARROW] = N_("Fold behind"),
    [KG_WORD_UNFOLD_ARROW] = N_("Fold and unfold"),
    [KG_WORD_TURN_SYMBOL] = N_("Turn over"),
    [KG_WORD_PATTERN_TEXT] =
        N_("All folds of the finished model, seen from the front of the paper."),
    [KG_WORD_CARD_FOOTER] = N_("%s · pop-up card"), /* title */
    [KG_WORD_CARD_GUIDE] = N_("Pop-up card"),
    [KG_WORD_CARD_SHEET] = N_("One sheet of %.4g × %.4g mm; stiff paper stands best."),
    [KG_WORD_CARD_CUT] = N_(
        "1. Score all fold lines, mountain folds on the printed side and valley folds on its back, "
        "or on one side only with a blunt point. Then cut along all solid lines."),
    [KG_WORD_CARD_SCORE] = N_(
        "2. Bend each fold a little: mountain folds away from you, valley folds towards you. Begin "
        "with the middle fold at both sides of the sheet, then go on from the largest box to the "
        "smallest. Push from behind with a finger or a stick."),
    [KG_WORD_CARD_OPEN] =
        N_("3. Bring the two halves together little by little, and help every fold to go its way, "
           "until the card stands open at 90°."),
    [KG_WORD_CARD_CLOSE] = N_(
        "4. Close it all the way and press it flat, so that all folds are sharp. Open it again."),
    [KG_WORD_CARD_NET] = N_("The sheet"),
    [KG_WORD_CUT_LINE] = N_("Cut"),
    [KG_WORD_CARD_AT] = N_("open at %.0f°"),
    [KG_WORD_CARD_CLOSED] = N_("closed"),
};

char *kg_words(char *out, size_t size, kg_word word, ...) {
    va_list values;
    va_start(values, word);
    kg_phrase_vprint(out, size, words[word], values);
    va_end(values);
    return out;
}

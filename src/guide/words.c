#include "guide/words.h"

#include "net/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Formats may be reordered with %2$s and the like; behind each: its values. */
static const char *const words[KG_WORD_COUNT] = {
    [KG_WORD_FOOTER] = "%s · assembly guide", /* title */
    [KG_WORD_UNTITLED] = "Paper model",
    [KG_WORD_GUIDE] = "Assembly guide",
    [KG_WORD_SIZE] = "%.0f × %.0f × %.0f mm (width × depth × height)",
    [KG_WORD_COUNTS] = "Parts: %d · pages of the net: %d · joins: %d",
    [KG_WORD_WORK] = "To cut: %.0f cm of line. To glue: %.0f cm. Roughly %s of work.",
    [KG_WORD_HOURS] = "%d h %02d min",
    [KG_WORD_MINUTES] = "%d minutes",
    [KG_WORD_PARTS] = "Parts",
    [KG_WORD_PART] = "part %d",            /* number */
    [KG_WORD_PART_NAMED] = "part %d (%s)", /* number, name */
    [KG_WORD_PAGE] = "page %d",            /* of the net */
    [KG_WORD_AND] = "%s %s",
    [KG_WORD_LEGEND] = "Lines and numbers",
    [KG_WORD_CUT] = "Cut along this line.",
    [KG_WORD_MOUNTAIN] =
        "Mountain fold: the printed side is outside the fold, the paper bends away from you.",
    [KG_WORD_VALLEY] =
        "Valley fold: the printed side is inside the fold, the paper bends towards you.",
    [KG_WORD_MARK] = "Mark: another part is glued onto the paper here. Neither cut nor fold.",
    [KG_WORD_TAB] =
        "Tab: fold it along its line, put the glue on it. Short teeth follow a bent edge.",
    [KG_WORD_NUMBERS] =
        "Each join has a number. It is printed at both edges of a seam, or at an edge and at the "
        "mark it comes to lie on: equal numbers belong together.",
    [KG_WORD_RULINGS] =
        "Thin lines in the list of parts show around which straight lines a part is rolled. They "
        "are not on the net. Roll before gluing, over the edge of a table or a round stick.",
    [KG_WORD_PICTURES] = "In the pictures the new part is orange, with its number in a box. The "
                         "joins to be glued are "
                         "red, with their numbers in rings; dashed arrows show where it goes. What "
                         "stands already is "
                         "pale, its inside brown.",
    [KG_WORD_GLUING] =
        "Score and fold all lines and roll all parts before you glue. Put little glue on a tab, "
        "begin at one end of the join and go on along it.",
    [KG_WORD_SUBASSEMBLY] = "Put aside what stands: no join leads from here to it.",
    [KG_WORD_START] = "Step %d · Begin with %s",
    [KG_WORD_OWN] = "Step %d · Glue %s to itself",
    [KG_WORD_ATTACH] = "Step %d · Attach %s",
    [KG_WORD_CLOSE] = "Step %d · Close %s",
    [KG_WORD_PLACE] = "Step %d · Place the sub-assembly of %s",
    [KG_WORD_FLAT] = "It stays flat. (Net page %d)",
    [KG_WORD_ROLL_OUT] =
        "Bend it with the printed side outside, radius %.0f mm where it is tightest. (Net page %d)",
    [KG_WORD_ROLL_IN] =
        "Bend it with the printed side inside, radius %.0f mm where it is tightest. (Net page %d)",
    [KG_WORD_ROLL_BOTH] =
        "Bend it into an S, to both sides, radius %.0f mm where it is tightest. (Net page %d)",
    [KG_WORD_FOLDS] = "Fold it along its %d inner fold lines.",
    [KG_WORD_SEAM] = "Seam with %s, %.0f mm.",                      /* part, length */
    [KG_WORD_CONTACT] = "Edge of %s onto the mark on %s, %.0f mm.", /* edge, mark, length */
    [KG_WORD_CONTACT_INSIDE] =
        "Edge of %s onto the back of %s, along its mark, %.0f mm. Prick the mark through first.",
    [KG_WORD_OWN_SEAM] = "Edge to edge of the same part, %.0f mm.",
    [KG_WORD_TABS_ON] = "The tabs are on %s.",
    [KG_WORD_NO_TABS] = "No tabs: glue edge to edge.",
    [KG_WORD_CLOSING] =
        "%d is a closing join: it closes a ring. Let the joins before it dry, and reach the tabs "
        "from inside through what is still open.",
    [KG_WORD_SEALS] =
        "%d is the closing seam: afterwards the inside cannot be reached any more. Fold its tabs "
        "a little less than they need, so that they press outwards against the other part; use "
        "slow glue, close it from one end to the other, and press from outside.",
    [KG_WORD_PLACE_TEXT] =
        "No join holds this sub-assembly. Place it as the picture shows, with a drop of glue or "
        "beside the rest.",
    [KG_WORD_SHEETS_FOOTER] = "%s · folding steps", /* title */
    [KG_WORD_SHEETS_GUIDE] = "Folding steps",
    [KG_WORD_SHEET_SIZE] = "Sheet %d: %.4g × %.4g mm", /* number, width, height */
    [KG_WORD_SHEETS_COUNTS] = "Folds: %d · crease pattern on the last page",
    [KG_WORD_CREASE_PATTERN] = "Crease pattern",
    [KG_WORD_TO_CORNER] = "Fold the corner to the other corner.",
    [KG_WORD_TO_CORNER_BEHIND] = "Fold the corner behind, to the other corner.",
    [KG_WORD_EDGE_TO_EDGE] = "Fold the edge to the other edge.",
    [KG_WORD_EDGE_TO_EDGE_BEHIND] = "Fold the edge behind, to the other edge.",
    [KG_WORD_TO_EDGE] = "Fold the corner to the circled point on the edge.",
    [KG_WORD_TO_EDGE_BEHIND] = "Fold the corner behind, to the circled point on the edge.",
    [KG_WORD_TO_POINT] = "Fold the corner to the circled point.",
    [KG_WORD_TO_POINT_BEHIND] = "Fold the corner behind, to the circled point.",
    [KG_WORD_ALONG_LINE] = "Fold along the dashed line.",
    [KG_WORD_ALONG_LINE_BEHIND] = "Fold behind along the line.",
    [KG_WORD_BY_ANGLE] = "Turn it by %.4g° only.",
    [KG_WORD_LAYERS] = "%d layers together.",
    [KG_WORD_TOP_LAYER] = "One layer only, of %d.",
    [KG_WORD_TOP_LAYERS] = "%d layers together, of %d.",
    [KG_WORD_TUCK] = "Tuck it between two layers.",
    [KG_WORD_UNFOLD] = "Unfold it again: the crease stays.",
    [KG_WORD_TURN_OVER] = "Turn the paper over.",
    [KG_WORD_SEEN_OBLIQUE] = "Seen from an angle.",
    [KG_WORD_FINISHED] = "The finished model.",
    [KG_WORD_COLLAPSED] = "Folded along all its creases.",
    [KG_WORD_LENGTH] = "%.6g mm",
    [KG_WORD_SIGNS] = "Lines and signs",
    [KG_WORD_VALLEY_LINE] = "Valley fold: towards you",
    [KG_WORD_MOUNTAIN_LINE] = "Mountain fold: away from you",
    [KG_WORD_OLD_CREASE] = "Crease from an earlier fold",
    [KG_WORD_VALLEY_ARROW] = "Fold in front",
    [KG_WORD_MOUNTAIN_ARROW] = "Fold behind",
    [KG_WORD_UNFOLD_ARROW] = "Fold and unfold",
    [KG_WORD_TURN_SYMBOL] = "Turn over",
    [KG_WORD_PATTERN_TEXT] = "All folds of the finished model, seen from the front of the paper.",
    [KG_WORD_CARD_FOOTER] = "%s · pop-up card", /* title */
    [KG_WORD_CARD_GUIDE] = "Pop-up card",
    [KG_WORD_CARD_SHEET] = "One sheet of %.4g × %.4g mm; stiff paper stands best.",
    [KG_WORD_CARD_CUT] =
        "1. Score all fold lines, mountain folds on the printed side and valley folds on its back, "
        "or on one side only with a blunt point. Then cut along all solid lines.",
    [KG_WORD_CARD_SCORE] =
        "2. Bend each fold a little: mountain folds away from you, valley folds towards you. Begin "
        "with the middle fold at both sides of the sheet, then go on from the largest box to the "
        "smallest. Push from behind with a finger or a stick.",
    [KG_WORD_CARD_OPEN] =
        "3. Bring the two halves together little by little, and help every fold to go its way, "
        "until the card stands open at 90°.",
    [KG_WORD_CARD_CLOSE] =
        "4. Close it all the way and press it flat, so that all folds are sharp. Open it again.",
    [KG_WORD_CARD_NET] = "The sheet",
    [KG_WORD_CUT_LINE] = "Cut",
    [KG_WORD_CARD_AT] = "open at %.0f°",
    [KG_WORD_CARD_CLOSED] = "closed",
};

char *kg_words(char *out, size_t size, kg_word word, ...) {
    va_list values;
    va_start(values, word);
    vsnprintf(out, size, words[word], values);
    va_end(values);
    for (size_t n = strlen(out); n > 0 && !kg_text_valid(out); n--)
        out[n - 1] = 0;
    return out;
}

#include "base/progress.h"

kg_status kg_progress_tell(const kg_progress *progress, double fraction, const char *what,
                           kg_error *error) {
    if (!progress || !progress->call || progress->call(progress->user, fraction, what))
        return KG_OK;
    return kg_fail(error, KG_ERR_CANCELLED, "cancelled");
}

static bool tell_whole(void *user, double fraction, const char *what) {
    const kg_progress_share *s = user;
    return s->whole->call(s->whole->user, s->from + fraction * (s->to - s->from), what);
}

kg_progress kg_progress_of_share(kg_progress_share *share) {
    bool is_told = share->whole && share->whole->call;
    return (kg_progress){is_told ? tell_whole : NULL, share};
}

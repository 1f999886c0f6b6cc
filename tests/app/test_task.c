/* Work in the background: where the gate is closed it goes on only as it is let. */
#include "app/task.h"
#include "tests/check.h"

enum { STEPS = 5 };

typedef struct work {
    kg_task task;
    atomic_int done; /* steps */
    bool ended;      /* by its own will, and not because it was cancelled */
} work;

static void step_on(void *user) {
    work *w = user;
    kg_progress progress = kg_task_progress(&w->task);
    for (int i = 1; i <= STEPS; i++) {
        atomic_store(&w->done, i);
        if (!progress.call(progress.user, (double)i / STEPS, ""))
            return;
    }
    w->ended = true;
}

static void an_open_gate_holds_nothing_up(void **state) {
    (void)state;
    kg_gate gate;
    kg_gate_init(&gate);
    work with = {0}, without = {0};
    assert_true(kg_task_start(&with.task, &gate, step_on, &with));
    assert_true(kg_task_start(&without.task, NULL, step_on, &without));
    kg_task_join(&with.task);
    kg_task_join(&without.task);
    assert_true(with.ended && without.ended && kg_task_is_done(&with.task));
    assert_near(kg_task_fraction(&with.task), 1, 1e-9);
    kg_gate_clear(&gate);
}

static void a_closed_gate_lets_work_go_on_step_by_step(void **state) {
    (void)state;
    kg_gate gate;
    kg_gate_init(&gate);
    kg_gate_set_closed(&gate, true);
    work a = {0}, b = {0};
    assert_true(kg_task_start(&a.task, &gate, step_on, &a));
    kg_gate_step(&gate);
    assert_int_equal(atomic_load(&a.done), 1);
    assert_true(kg_task_start(&b.task, &gate, step_on, &b));
    for (int i = 2; i <= STEPS; i++) {
        kg_gate_step(&gate);
        assert_int_equal(atomic_load(&a.done), i);
        assert_int_equal(atomic_load(&b.done), i - 1);
        assert_near(kg_task_fraction(&a.task), (double)i / STEPS, 1e-9);
        assert_false(kg_task_is_done(&a.task));
    }
    kg_gate_step(&gate);
    assert_true(kg_task_is_done(&a.task) && a.ended && !kg_task_is_done(&b.task));
    kg_gate_set_closed(&gate, false);
    kg_task_join(&a.task);
    kg_task_join(&b.task);
    assert_true(b.ended);
    kg_gate_clear(&gate);
}

static void what_is_cancelled_or_joined_waits_at_no_gate(void **state) {
    (void)state;
    kg_gate gate;
    kg_gate_init(&gate);
    kg_gate_set_closed(&gate, true);
    work cancelled = {0}, joined = {0};
    assert_true(kg_task_start(&cancelled.task, &gate, step_on, &cancelled));
    assert_true(kg_task_start(&joined.task, &gate, step_on, &joined));
    kg_task_cancel(&cancelled.task);
    kg_task_join(&cancelled.task);
    assert_true(!cancelled.ended && atomic_load(&cancelled.done) == 1);
    assert_false(kg_task_is_done(&joined.task));
    kg_task_join(&joined.task);
    assert_true(joined.ended);
    kg_gate_step(&gate); /* nobody is left to wait for */
    kg_gate_clear(&gate);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_open_gate_holds_nothing_up),
        cmocka_unit_test(a_closed_gate_lets_work_go_on_step_by_step),
        cmocka_unit_test(what_is_cancelled_or_joined_waits_at_no_gate),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

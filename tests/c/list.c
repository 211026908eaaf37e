/*
 * The list of 1994: complete, closed both ways, each element one malloc;
 * freed only if the library made it.
 */
#include "check.h"

/* A head as a host of 1994 has it: malloc, number = -1, all else garbage. */
static V_KAMERAPAR *new_head(void)
{
    V_KAMERAPAR *head = (V_KAMERAPAR *)malloc(sizeof *head);
    memset(head, 0xa5, sizeof *head);
    head->number = -1;
    return head;
}

/* A straight way of `frames` + 1 poses, each looking along -z. */
static V_PATH *straight(double frames, double zoom)
{
    V_PATH *path = new_path();
    V_ORIENTATION o;
    v_orientation_init(&o);
    o.zoom = zoom;
    OK(v_path_set_orientation(path, 0, 0, &o));
    OK(v_path_set_orientation(path, 1, 0, &o));
    OK(v_path_set_numbers(path, "base_speeds", NUMBERS(frames / 1.2, 100, 100, 100)));
    return path;
}

/* The list is whole, forwards and backwards, and has the poses of the path. */
static void is_list_of(const V_KAMERAPAR *first, const V_PATH *path)
{
    const V_KAMERAPAR *element = first;
    size_t count = 0, i;
    int k;
    OK(v_path_frame_count(path, &count));
    CHECK(first->prev->number == (int)count);
    for (i = 0; i < count; i++) {
        V_POSE pose;
        OK(v_path_pose(path, (double)i + 1, &pose));
        for (k = 0; k < 3; k++) {
            CHECK((&element->VRP.x)[k] == (float)pose.vrp[k]);
            CHECK((&element->VPN.x)[k] == (float)pose.vpn[k]);
            CHECK((&element->VUP.x)[k] == (float)pose.vup[k]);
        }
        CHECK(element->zoom == (int)floor(pose.zoom + 0.5));
        CHECK(element->number == (int)i + 1);
        CHECK(element->next->prev == element && element->prev->next == element);
        element = element->next;
    }
    CHECK(element == first);
    for (i = count; i > 0; i--) {
        element = element->prev;
        CHECK(element->number == (int)i);
    }
    CHECK(element == first);
}

static void a_fresh_head(void)
{
    V_PATH *path = straight(600, 24);
    V_KAMERAPAR *head = new_head();
    OK(v_path_to_list(path, head));
    is_list_of(head, path);
    NEAR(head->VRP.x, -0.6f, 0);
    NEAR(head->prev->VRP.x, 0.6f, 0);
    CHECK(head->number == 1 && head->prev->number == 601);
    v_free_liste(head);
    CHECK(v_last_error()[0] == '\0' && head->number == -1);
    v_free_liste(head); /* no data: nothing to be done */
    CHECK(v_last_error()[0] == '\0' && head->number == -1);
    free(head);
    v_path_free(path);
}

static void the_list_outlives_the_path(void)
{
    V_PATH *path = straight(10, 24);
    V_KAMERAPAR *head = new_head();
    OK(v_path_to_list(path, head));
    v_path_free(path);
    CHECK(head->prev->number == 11 && head->prev->prev->next->next == head);
    v_free_liste(head);
    free(head);
}

/* The button pressed twice: the old elements are freed (or valgrind tells). */
static void the_same_head_again(void)
{
    V_PATH *path = straight(100, 24), *longer = straight(300, 24);
    V_KAMERAPAR *head = new_head();
    OK(v_path_to_list(path, head));
    OK(v_path_to_list(longer, head));
    is_list_of(head, longer);
    OK(v_path_to_list(path, head));
    is_list_of(head, path);
    head->number = 0; /* "data" for every program that asks for >= 0 */
    OK(v_path_to_list(path, head));
    is_list_of(head, path);
    v_free_liste(head);
    free(head);
    v_path_free(path);
    v_path_free(longer);
}

/* A host that keeps an element has it still, until a list is too short for it. */
static void a_kept_element(void)
{
    double frames[] = {100, 300, 100, 20, 19, 1, 2, 40};
    V_KAMERAPAR *head = new_head(), *kept = NULL, *element;
    size_t i;
    int n, before = 0;
    for (i = 0; i < sizeof frames / sizeof *frames; i++) {
        V_PATH *path = straight(frames[i], 24 + (double)i);
        OK(v_path_to_list(path, head));
        is_list_of(head, path);
        if (before >= 15 && head->prev->number >= 15)
            CHECK(head->next->next->next->next->next == kept);
        for (element = head, n = 1; n < 6; n++)
            element = element->next;
        kept = element;
        before = head->prev->number;
        v_path_free(path);
    }
    v_free_liste(head);
    CHECK(v_last_error()[0] == '\0');
    free(head);
}

/* The elements are the host's to free, too. */
static void the_host_frees(void)
{
    V_PATH *path = straight(100, 24);
    V_KAMERAPAR *head = new_head(), *element;
    OK(v_path_to_list(path, head));
    for (element = head->next; element != head;) {
        V_KAMERAPAR *next = element->next;
        free(element);
        element = next;
    }
    head->number = -1; /* prev and next dangle now */
    OK(v_path_to_list(path, head));
    is_list_of(head, path);
    for (element = head->next; element != head;) {
        V_KAMERAPAR *next = element->next;
        free(element);
        element = next;
    }
    head->number = -1;
    v_free_liste(head);
    CHECK(v_last_error()[0] == '\0');
    free(head);
    v_path_free(path);
}

/* A list on the stack, which must never be freed: (frees) crash or tell. */
static void somebody_elses_list(void)
{
    V_PATH *path = straight(10, 24);
    V_KAMERAPAR own[3], kept[3];
    int i;
    memset(own, 0, sizeof own);
    for (i = 0; i < 3; i++) {
        own[i].number = i + 1;
        own[i].next = &own[(i + 1) % 3];
        own[i].prev = &own[(i + 2) % 3];
    }
    memcpy(kept, own, sizeof own);
    v_free_liste(own);
    CHECK(v_last_error()[0] != '\0');
    CHECK(memcmp(kept, own, sizeof own) == 0);

    OK(v_path_to_list(path, own)); /* takes the head, leaves the rest alone */
    is_list_of(own, path);
    CHECK(memcmp(kept + 1, own + 1, 2 * sizeof own[0]) == 0);
    v_free_liste(own);
    CHECK(own[0].number == -1);

    /* Zeroed: data, it says, but no links. */
    memset(own, 0, sizeof own);
    OK(v_path_to_list(path, own));
    is_list_of(own, path);

    /* A list of the library's that the host has changed is the host's. */
    {
        V_KAMERAPAR *second = own[0].next, *third = second->next;
        own[0].next = third;
        third->prev = &own[0];
        v_free_liste(own);
        CHECK(v_last_error()[0] != '\0' && own[0].number == 1);
        own[0].next = second;
        third->prev = second;
        third->number = 17;
        v_free_liste(own);
        CHECK(v_last_error()[0] != '\0' && own[0].number == 1);
        third->number = 3;
        third->next->prev = second;
        v_free_liste(own);
        CHECK(v_last_error()[0] != '\0' && own[0].number == 1);
        third->next->prev = third;
        own[0].prev->next = second;
        v_free_liste(own);
        CHECK(v_last_error()[0] != '\0' && own[0].number == 1);
        own[0].prev->next = own;
        v_free_liste(own); /* all as it was made */
        CHECK(v_last_error()[0] == '\0' && own[0].number == -1);
    }

    /* A copy of a head is another head. */
    OK(v_path_to_list(path, &own[0]));
    own[1] = own[0];
    v_free_liste(&own[1]);
    CHECK(v_last_error()[0] != '\0' && own[1].number == 1);
    v_free_liste(&own[0]);
    CHECK(v_last_error()[0] == '\0');
    v_path_free(path);
}

static void one_pose(void)
{
    V_PATH *path = new_path();
    V_KAMERAPAR *head = new_head();
    double xyz[3];
    OK(get_position(path, 0, xyz));
    OK(set_position(path, 1, xyz));
    OK(v_path_to_list(path, head));
    CHECK(head->number == 1 && head->prev == head && head->next == head);
    is_list_of(head, path);
    OK(v_path_to_list(path, head));
    v_free_liste(head);
    CHECK(v_last_error()[0] == '\0' && head->number == -1);
    free(head);
    v_path_free(path);
}

/* Zoom is rounded half away from zero, and 100 at most. */
static void rounding(void)
{
    static const struct { double zoom; int rounded; } cases[] = {
        {1, 1}, {1.4999999999999998, 1}, {1.5, 2}, {2.5, 3}, {3.5, 4},
        {24.499999999999996, 24}, {24.5, 25}, {99.49999999999999, 99}, {99.5, 100}, {100, 100},
        {100.4, 100}, {100.5, 100}, {135, 100}, {2000, 100},
    };
    size_t i;
    for (i = 0; i < sizeof cases / sizeof *cases; i++) {
        V_PATH *path = straight(2, cases[i].zoom);
        V_KAMERAPAR head;
        head.number = -1;
        OK(v_path_to_list(path, &head));
        CHECK(head.zoom == cases[i].rounded);
        CHECK(head.prev->zoom == cases[i].rounded);
        v_free_liste(&head);
        v_path_free(path);
    }
}

/* Around the size of the blocks in which poses are computed. */
static void every_length(void)
{
    static const int frames[] = {1, 2, 254, 255, 256, 257, 511, 512, 513, 5000};
    size_t i;
    for (i = 0; i < sizeof frames / sizeof *frames; i++) {
        V_PATH *path = straight(frames[i], 24);
        V_KAMERAPAR *head = new_head();
        OK(v_path_to_list(path, head));
        CHECK(head->prev->number == frames[i] + 1);
        is_list_of(head, path);
        v_free_liste(head);
        free(head);
        v_path_free(path);
    }
}

/* Many lists at once, and a head on an address that had one before. */
static void many_heads(void)
{
    V_PATH *path = straight(3, 24);
    V_KAMERAPAR heads[500];
    int i, round;
    for (round = 0; round < 3; round++) {
        for (i = 0; i < 500; i++) {
            memset(&heads[i], 0xa5, sizeof heads[i]);
            heads[i].number = -1;
            OK(v_path_to_list(path, &heads[i]));
        }
        for (i = 0; i < 500; i++) {
            CHECK(heads[i].prev->number == 4);
            v_free_liste(&heads[i]);
            CHECK(heads[i].number == -1);
        }
    }
    v_path_free(path);
}

int main(void)
{
    a_fresh_head();
    the_list_outlives_the_path();
    the_same_head_again();
    a_kept_element();
    the_host_frees();
    somebody_elses_list();
    one_pose();
    rounding();
    every_length();
    many_heads();
    return failures != 0;
}

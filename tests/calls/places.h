/*
 * Where a library that is built for it (crates/engine/src/inject.rs) can be told to panic, or
 * tells that it came by.
 */
#ifndef PLACES_H
#define PLACES_H

enum place {
    CALL, PATH, DISPATCH, EVENT, TURN, LAYOUT, PAINT, HAND_OVER, PREPARED, CALLBACK, PLACES
};

void v_test_panic(int place, int after);
int v_test_passed(void);
void v_test_tell(void (*tell)(int place));

#endif

/*
 * Somebody at the windows: an X client of its own that sends them what a user
 * and a window manager would, and what neither would. Events are sent, not
 * typed, so that no window needs the focus or to be seen.
 */
#ifndef HANDS_H
#define HANDS_H

/* Connects to the display of the environment; 0 if there is none. */
int hands_connect(void);
void hands_leave(void);

/* How many windows of the library there are. */
int hands_count(void);
/* One of them, the newest being the last; 0 if there are fewer. */
unsigned long hands_window(int number);

/* Nothing is before it. */
void hands_raise(unsigned long window);
/* Alt-U: the poses are to be handed over. */
void hands_hand_over(unsigned long window);
/* Another point becomes current; there is one orientation more; the host's view is
 * taken over; the camera pane goes, or comes again. */
void hands_next_point(unsigned long window);
void hands_change(unsigned long window);
/* A letter is typed. */
void hands_type(unsigned long window);
void hands_take_over(unsigned long window);
void hands_switch_pane(unsigned long window);
/* What a window manager sends when its cross is pressed. */
void hands_close(unsigned long window);
/* The window is gone without a word. */
void hands_destroy(unsigned long window);
/* The connection of the window ends. */
void hands_kill(unsigned long window);

/* How many kinds of events hands_send() knows. */
int hands_kinds(void);
/* Sends an event of this kind, its contents made of `noise`. */
void hands_send(unsigned long window, int kind, unsigned long long noise);
/* Nobody but us is served, until hands_let_go(); what we send arrives all the same. */
void hands_take_all(void);
void hands_let_go(void);
/* All that was sent has reached the server, and what it answers has come. */
void hands_finish(void);

#endif

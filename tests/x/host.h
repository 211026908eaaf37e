/*
 * A host that does what it is told: reads commands from standard input, one a
 * line, and answers on standard output. host.c knows the commands; each
 * loop_*.c is an event loop that calls command() when a line has come.
 */
#ifndef HOST_H
#define HOST_H

/* To be called once, before anything else. */
void begin(void);

/* Reads what is there on standard input and does the commands in it; ends the
 * program at its end. Never blocks for more than the rest of a line. */
void commands(void);

/* One answer; formatted as printf does it, a line, sent at once. */
void say(const char *format, ...);

/* What a loop may know beyond host.c; 0 if it does not know the command. */
int loop_command(const char *name, char *rest);

#endif

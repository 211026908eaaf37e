"""Runs the tests under X servers of their own: run.py HOSTS_FOLDER [NAME...]

Several at once, since most of their time is waiting. One line for each, those
that failed once more at the end; the exit status is 1 if one failed. A failed
test leaves its folder, with a picture of the screen, in HOSTS_FOLDER/failed.
"""

import concurrent.futures
import os
import shutil
import sys
import tempfile
import threading
import time
import traceback

import harness

SIDE_BY_SIDE = 4
BOTH = ("archive", "shared")
TESTS = {}
_printing = threading.Lock()


def test(kinds=None, first=False, at_once=SIDE_BY_SIDE):
    """Marks a test: it is run for each of these kinds of library. What hangs on how a program
    is linked, loaded or ended says BOTH; of the others every second one is for each kind, since
    both are made of the same object, unless it is chosen by its name or EACH is set.

    Those that take long say `first`, so that nothing waits for them at the end.
    Those that look at the clock say how many of them a processor bears `at_once`,
    and run after all others: their own work is little, so it may be several.
    """
    def mark(function):
        where = TESTS.setdefault(at_once, [])
        turn = sum(map(len, TESTS.values())) // 2 % 2
        for kind in kinds or BOTH:
            thin = kinds is None and kind != BOTH[turn]
            where.insert(0 if first else len(where), (function, kind, thin))
        return function
    return mark


class Place:
    """Where a test runs: makes servers and programs, and takes them away."""

    def __init__(self, hosts, kind, folder):
        self.hosts, self.kind, self.folder = hosts, kind, folder
        self.servers, self.programs = [], []
        self.wrapper = ()  # a command that runs the programs

    def server(self, *arguments, **options):
        """A new X server."""
        folder = os.path.join(self.folder, f"server{len(self.servers)}")
        os.mkdir(folder)
        made = harness.Server(folder, *arguments, **options)
        self.servers.append(made)
        return made

    def path(self, name):
        """A file in the folder in which the programs run."""
        return os.path.join(self.folder, name)

    def binary(self, name):
        """A host, linked with this kind of library."""
        return os.path.join(self.hosts, f"{name}-{self.kind}")

    def told(self, server, name="loop_poll", *arguments, **variables):
        """The host that does what it is told. A variable that is None is unset."""
        env = self._environment(server, variables)
        command = [*self.wrapper, self.binary(name), *arguments]
        program = harness.Told(self.folder, command, env)
        self.programs.append(program)
        return program

    def program(self, server, name, *arguments, **variables):
        """Any other host, on a terminal."""
        env = self._environment(server, variables)
        command = [*self.wrapper, self.binary(name), *arguments]
        program = harness.Program(self.folder, command, env, terminal=True)
        self.programs.append(program)
        return program

    def _environment(self, server, variables):
        env = dict(server.env if server else harness.clean_environment(self.folder))
        for name, value in variables.items():
            env.pop(name, None)
            if value is not None:
                env[name] = value
        return env

    def end(self):
        """Takes everything away."""
        for program in self.programs:
            program.kill()
        for server in self.servers:
            server.end()


def _run(function, kind, hosts):
    """Gives what is to be said of a failure, or nothing."""
    name = f"{function.__name__.replace('_', ' ')}, {kind}"
    folder = tempfile.mkdtemp(prefix="vides-x-")
    place = Place(hosts, kind, folder)
    start = time.monotonic()
    error = None
    try:
        function(place)
    except Exception as caught:  # pylint: disable=broad-except
        error = caught
        trace = traceback.extract_tb(caught.__traceback__)
        lines = [f"{os.path.basename(at.filename)}:{at.lineno}" for at in trace]
        for number, server in enumerate(place.servers):
            try:
                server.picture().save(os.path.join(folder, f"screen{number}.png"))
            except Exception:  # pylint: disable=broad-except
                pass  # it may be the server that was killed
    finally:
        place.end()
    seconds = time.monotonic() - start
    with _printing:
        if error is None:
            print(f"x: ok: {name} ({seconds:.1f} s)", flush=True)
            shutil.rmtree(folder, ignore_errors=True)
            return None
        kept = os.path.join(hosts, "failed", name.replace(", ", "-").replace(" ", "-"))
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder, kept, ignore_dangling_symlinks=True,
                        ignore=shutil.ignore_patterns("*.sock"))
        shutil.rmtree(folder, ignore_errors=True)
        message = str(error) if isinstance(error, harness.Failure) else repr(error)
        said = [f"x: FAILED: {name} ({seconds:.1f} s)", f"    {' '.join(lines[1:])}: {message}"]
        said += [f"    its standard error: {line}"
                 for program in place.programs for line in program.complained[-5:]]
        said = "\n".join([*said, f"    kept: {kept}"])
        print(said, flush=True)
        return said


def main():
    """Runs all tests, or those whose names contain one of the words given."""
    sys.modules["run"] = sys.modules["__main__"]  # the cases import it
    hosts = os.path.abspath(sys.argv[1])
    for name in sorted(os.listdir(os.path.dirname(os.path.abspath(__file__)))):
        if name.startswith("cases_") and name.endswith(".py"):
            __import__(name[:-3])
    words = [word.replace(" ", "_") for word in sys.argv[2:]]

    results = []
    for at_once in sorted(TESTS, reverse=True):
        chosen = [(function, kind) for function, kind, thin in TESTS[at_once]
                  if (any(word in f"{function.__name__},_{kind}" for word in words) if words
                      else not thin or os.environ.get("EACH"))]
        with concurrent.futures.ThreadPoolExecutor(at_once) as pool:
            results += pool.map(lambda one: _run(*one, hosts), chosen)
    failures = [said for said in results if said]
    if failures:  # once more, where one looks first
        print("", *failures, sep="\n")
    print(f"x: {len(results) - len(failures)} passed, {len(failures)} failed")
    return 0 if results and not failures else 1


if __name__ == "__main__":
    sys.exit(main())

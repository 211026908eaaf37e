"""on_a_screen.py COMMAND...: runs it with an X server without a screen, whose number the server itself finds.

(`xvfb-run -a` guesses one, and takes another's where several servers start at once.)
"""

import os
import subprocess
import sys


def main():
    reads, writes = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writes), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[writes], stderr=subprocess.DEVNULL,
    )  # fmt: skip
    os.close(writes)
    try:
        with os.fdopen(reads) as number:
            os.environ["DISPLAY"] = ":" + number.readline().strip()
        return subprocess.run(sys.argv[1:], check=False).returncode
    finally:
        server.terminate()
        server.wait()


if __name__ == "__main__":
    code = main()
    # A signal is told as the shell does.
    sys.exit(code if code >= 0 else 128 - code)

"""tk_flight with a dialog of its own: M opens it."""

import os
import sys
from tkinter import messagebox

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../c_examples"))

from tk_flight import Flight  # noqa: E402

flight = Flight()
flight.top.bind("m", lambda event: messagebox.showinfo("dialog", "A dialog"))
flight.top.mainloop()

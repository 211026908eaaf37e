//! Texts about unsaved work that is kept and offered.

use super::texts;

texts! {
    Recovery {
        title: "Unsaved work was found", "Nicht gespeicherte Arbeit gefunden";
        question: "A program ended before this was saved.",
            "Ein Programm wurde beendet, bevor dies gespeichert war.";
        restore_hint: "Open this work here, unsaved as it was",
            "Diese Arbeit hier öffnen, nicht gespeichert, wie sie war";
        discard_hint: "Delete this work for good", "Diese Arbeit endgültig löschen";
        picture: "The path", "Die Bahn";
        scene: "The scene", "Die Szene";
        unreadable: "This cannot be read", "Das ist nicht lesbar";
        date: "{0}-{1}-{2}, {3}:{4}", "{2}.{1}.{0}, {3}:{4}";
        restore: "Restore", "Wiederherstellen";
        discard: "Discard", "Verwerfen";
        discard_now: "Really discard", "Wirklich verwerfen";
        later: "Later", "Später";
        later_hint: "Keep it and ask again at the next start",
            "Aufheben und beim nächsten Start wieder fragen";
        just_now: "less than a minute ago", "vor weniger als einer Minute";
        minutes: "{0} min ago", "vor {0} min";
        hours: "{0} hours ago", "vor {0} Stunden";
        days: "{0} days ago", "vor {0} Tagen";
        restored: "Unsaved work restored", "Nicht gespeicherte Arbeit wiederhergestellt";
        broken: "This cannot be restored: {0}", "Das lässt sich nicht wiederherstellen: {0}";
        not_kept: "Unsaved work cannot be kept in {0}: {1}. It is lost if the program crashes",
            "Nicht gespeicherte Arbeit lässt sich nicht in {0} aufheben: {1}. Bei einem Absturz geht sie verloren";
    }
}

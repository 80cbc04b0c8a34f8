"""Task panels and dialogs: what a user sees."""

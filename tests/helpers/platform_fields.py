"""Required contents of files for learning platforms: Moodle 5's importer, PrairieLearn's schema; for STACK, ours."""

from __future__ import annotations

NEEDED = {
    "numerical": ["name/text", "questiontext/text", "answer/text", "answer/tolerance", "answer/feedback/text"],
    "calculated": [
        *(
            f"answer/{tag}"
            for tag in ("text", "tolerance", "tolerancetype", "correctanswerformat", "correctanswerlength")
        ),
        *(f"{tag}/text" for tag in ("correctfeedback", "partiallycorrectfeedback", "incorrectfeedback")),
        *(
            f"dataset_definitions/dataset_definition/{tag}"
            for tag in (
                *("status/text", "name/text", "type", "distribution/text", "minimum/text", "maximum/text"),
                *(
                    "decimals/text",
                    "itemcount",
                    "dataset_items/dataset_item/number",
                    "dataset_items/dataset_item/value",
                ),
            )
        ),
    ],
    "stack": [
        *("stackversion/text", "questionvariables/text", "specificfeedback/text", "questionnote/text", "deployedseed"),
        *(f"input/{tag}" for tag in ("name", "type", "tans", "boxsize", "mustverify", "showvalidation")),
        *(f"prt/{tag}" for tag in ("name", "value", "autosimplify", "feedbackvariables/text")),
        *(f"prt/node/{tag}" for tag in ("name", "answertest", "sans", "tans", "testoptions", "quiet")),
        *(
            f"prt/node/{side}{tag}"
            for side in ("true", "false")
            for tag in ("scoremode", "score", "nextnode", "answernote")
        ),
    ],
}
"""Fields that Moodle's importer reads without checking for them, and the fields of our questions for STACK."""
INFO = {
    "comment",
    "uuid",
    "type",
    "title",
    "topic",
    "tags",
    "gradingMethod",
    "singleVariant",
    "partialCredit",
    "options",
}
"""Keys of info.json allowed by PrairieLearn's schema, for questions without a separate server."""

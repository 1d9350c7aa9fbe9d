<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>glenoid::JobsBar</name>
    <message numerus="yes">
        <source>%1 (about %n minute(s) left)</source>
        <translation>
            <numerusform>%1 (about %n minute left)</numerusform>
            <numerusform>%1 (about %n minutes left)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (about %n second(s) left)</source>
        <translation>
            <numerusform>%1 (about %n second left)</numerusform>
            <numerusform>%1 (about %n seconds left)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::MainWindow</name>
    <message numerus="yes">
        <source>%n step(s) could not be taken; the last good state was kept</source>
        <translation>
            <numerusform>%n step could not be taken; the last good state was kept</numerusform>
            <numerusform>%n steps could not be taken; the last good state was kept</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ProblemsPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::StatusFigures</name>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation>
            <numerusform>%n contact</numerusform>
            <numerusform>%n contacts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n island(s)</source>
        <translation>
            <numerusform>%n island</numerusform>
            <numerusform>%n islands</numerusform>
        </translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>glenoid::Authoring</name>
    <message numerus="yes">
        <source>Select %n triangle(s)</source>
        <translation>
            <numerusform>Select %n triangle</numerusform>
            <numerusform>Select %n triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::BodyPanel</name>
    <message numerus="yes">
        <source>%n triangle(s) matter more than the others.</source>
        <translation>
            <numerusform>%n triangle matters more than the others.</numerusform>
            <numerusform>%n triangles matter more than the others.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are seen</source>
        <translation>
            <numerusform>%n triangle is seen</numerusform>
            <numerusform>%n triangles are seen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) collide</source>
        <translation>
            <numerusform>%n triangle collides</numerusform>
            <numerusform>%n triangles collide</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tetrahedron(s) deform</source>
        <translation>
            <numerusform>%n tetrahedron deforms</numerusform>
            <numerusform>%n tetrahedra deform</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tetrahedron(s)</source>
        <translation>
            <numerusform>%n tetrahedron</numerusform>
            <numerusform>%n tetrahedra</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The tetrahedra fall into %n piece(s): take smaller cells.</source>
        <translation>
            <numerusform>The tetrahedra form %n piece.</numerusform>
            <numerusform>The tetrahedra fall into %n pieces: take smaller cells.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::CagePanel</name>
    <message numerus="yes">
        <source>%n handle(s); pick some in the view to move them.</source>
        <translation>
            <numerusform>%n handle; pick it in the view to move it.</numerusform>
            <numerusform>%n handles; pick some in the view to move them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n handle(s) picked. Their mean shift from rest:</source>
        <translation>
            <numerusform>%n handle picked. Its shift from rest:</numerusform>
            <numerusform>%n handles picked. Their mean shift from rest:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of parts</source>
        <translation>
            <numerusform>%n pair of parts</numerusform>
            <numerusform>%n pairs of parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n cut(s)</source>
        <translation>
            <numerusform>%n cut</numerusform>
            <numerusform>%n cuts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of parts overlap at the start.</source>
        <translation>
            <numerusform>%n pair of parts overlaps at the start.</numerusform>
            <numerusform>%n pairs of parts overlap at the start.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Moving cages apart: %n pair(s) still overlap.</source>
        <translation>
            <numerusform>Moving cages apart: %n pair still overlaps.</numerusform>
            <numerusform>Moving cages apart: %n pairs still overlap.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) still overlap; move their cages by hand or allow more handles.</source>
        <translation>
            <numerusform>%n pair still overlaps; move its cages by hand or allow more handles.</numerusform>
            <numerusform>%n pairs still overlap; move their cages by hand or allow more handles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::CouplingPanel</name>
    <message numerus="yes">
        <source>%n triangle(s) selected</source>
        <translation>
            <numerusform>%n triangle selected</numerusform>
            <numerusform>%n triangles selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n spring</numerusform>
            <numerusform>%n springs</numerusform>
        </translation>
    </message>
</context>
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

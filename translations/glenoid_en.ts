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
    <message numerus="yes">
        <source>Select %n node(s)</source>
        <translation>
            <numerusform>Select %n node</numerusform>
            <numerusform>Select %n nodes</numerusform>
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
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n node</numerusform>
            <numerusform>%n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) selected</source>
        <translation>
            <numerusform>%n node selected</numerusform>
            <numerusform>%n nodes selected</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ImportDialog</name>
    <message numerus="yes">
        <source>%n surface(s) will be added as rigid parts.</source>
        <translation>
            <numerusform>%n surface will be added as a rigid part.</numerusform>
            <numerusform>%n surfaces will be added as rigid parts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n could not be read.</source>
        <translation>
            <numerusform>%n could not be read.</numerusform>
            <numerusform>%n could not be read.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them are not sound: the joint will not run before that is mended.</source>
        <translation>
            <numerusform>%n of them is not sound: the joint will not run before that is mended.</numerusform>
            <numerusform>%n of them are not sound: the joint will not run before that is mended.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ImportSession</name>
    <message numerus="yes">
        <source>Import %n surface(s)</source>
        <translation>
            <numerusform>Import %n surface</numerusform>
            <numerusform>Import %n surfaces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ImportWords</name>
    <message numerus="yes">
        <source>It consists of %n piece(s).</source>
        <translation>
            <numerusform>It consists of %n piece.</numerusform>
            <numerusform>It consists of %n pieces.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) belong to no triangle.</source>
        <translation>
            <numerusform>%n point belongs to no triangle.</numerusform>
            <numerusform>%n points belong to no triangle.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) lie on others.</source>
        <translation>
            <numerusform>%n point lies on another.</numerusform>
            <numerusform>%n points lie on others.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) have no area.</source>
        <translation>
            <numerusform>%n triangle has no area.</numerusform>
            <numerusform>%n triangles have no area.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>%n triangle is there twice.</numerusform>
            <numerusform>%n triangles are there twice.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) have three or more triangles.</source>
        <translation>
            <numerusform>%n edge has three or more triangles.</numerusform>
            <numerusform>%n edges have three or more triangles.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) pinch the surface.</source>
        <translation>
            <numerusform>%n point pinches the surface.</numerusform>
            <numerusform>%n points pinch the surface.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) the triangles face contrary ways.</source>
        <translation>
            <numerusform>At %n edge the triangles face contrary ways.</numerusform>
            <numerusform>At %n edges the triangles face contrary ways.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) are inside out.</source>
        <translation>
            <numerusform>%n piece is inside out.</numerusform>
            <numerusform>%n pieces are inside out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s); the longest is %1 mm around.</source>
        <translation>
            <numerusform>%n hole, %1 mm around.</numerusform>
            <numerusform>%n holes; the longest is %1 mm around.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) have no thickness.</source>
        <translation>
            <numerusform>%n piece has no thickness.</numerusform>
            <numerusform>%n pieces have no thickness.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The surface has %n handle(s), as a ring has one.</source>
        <translation>
            <numerusform>The surface has %n handle, as a ring has.</numerusform>
            <numerusform>The surface has %n handles, as a ring has one.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of triangles cut each other.</source>
        <translation>
            <numerusform>%n pair of triangles cut each other.</numerusform>
            <numerusform>%n pairs of triangles cut each other.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n polygon(s) were cut into triangles.</source>
        <translation>
            <numerusform>%n polygon was cut into triangles.</numerusform>
            <numerusform>%n polygons were cut into triangles.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle strip(s) were cut into triangles.</source>
        <translation>
            <numerusform>%n triangle strip was cut into triangles.</numerusform>
            <numerusform>%n triangle strips were cut into triangles.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeated point(s) were joined.</source>
        <translation>
            <numerusform>%n repeated point was joined.</numerusform>
            <numerusform>%n repeated points were joined.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) had a transform, which was applied.</source>
        <translation>
            <numerusform>%n node had a transform, which was applied.</numerusform>
            <numerusform>%n nodes had a transform, which was applied.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) were mirrored; their triangles were turned back.</source>
        <translation>
            <numerusform>%n node was mirrored; its triangles were turned back.</numerusform>
            <numerusform>%n nodes were mirrored; their triangles were turned back.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) were left out.</source>
        <translation>
            <numerusform>%n line was left out.</numerusform>
            <numerusform>%n lines were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n single point(s) were left out.</source>
        <translation>
            <numerusform>%n single point was left out.</numerusform>
            <numerusform>%n single points were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Normals of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Normals of %n surface were left out.</numerusform>
            <numerusform>Normals of %n surfaces were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Texture coordinates of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Texture coordinates of %n surface were left out.</numerusform>
            <numerusform>Texture coordinates of %n surfaces were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Colours of %n surface were left out.</numerusform>
            <numerusform>Colours of %n surfaces were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n material(s) were left out.</source>
        <translation>
            <numerusform>%n material was left out.</numerusform>
            <numerusform>%n materials were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n animation(s) or bone(s) were left out.</source>
        <translation>
            <numerusform>%n animation or bone was left out.</numerusform>
            <numerusform>%n animations or bones were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n light(s) or camera(s) were left out.</source>
        <translation>
            <numerusform>%n light or camera was left out.</numerusform>
            <numerusform>%n lights or cameras were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n array(s) of values were left out.</source>
        <translation>
            <numerusform>%n array of values was left out.</numerusform>
            <numerusform>%n arrays of values were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) without triangles were left out.</source>
        <translation>
            <numerusform>%n surface without triangles was left out.</numerusform>
            <numerusform>%n surfaces without triangles were left out.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n solid cell(s) the outside was taken.</source>
        <translation>
            <numerusform>Of %n solid cell the outside was taken.</numerusform>
            <numerusform>Of %n solid cells the outside was taken.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::IslandRows</name>
    <message numerus="yes">
        <source>%1 touches %2: %n contact(s), %3 N</source>
        <translation>
            <numerusform>%1 touches %2: %n contact, %3 N</numerusform>
            <numerusform>%1 touches %2: %n contacts, %3 N</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 touches itself: %n contact(s), %2 N</source>
        <translation>
            <numerusform>%1 touches itself: %n contact, %2 N</numerusform>
            <numerusform>%1 touches itself: %n contacts, %2 N</numerusform>
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
    <message numerus="yes">
        <source>Delete %n part(s)</source>
        <translation>
            <numerusform>Delete %n part</numerusform>
            <numerusform>Delete %n parts</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::NoticeStrip</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n more</numerusform>
            <numerusform>%n more</numerusform>
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
    <message numerus="yes">
        <source>%n notice(s) about the run</source>
        <translation>
            <numerusform>%n notice about the run</numerusform>
            <numerusform>%n notices about the run</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::PropertiesPanel</name>
    <message numerus="yes">
        <source>%n picked node(s)</source>
        <translation>
            <numerusform>%n picked node</numerusform>
            <numerusform>%n picked nodes</numerusform>
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
<context>
    <name>glenoid::StudyBar</name>
    <message numerus="yes">
        <source>%1 % done, about %n second(s) left</source>
        <translation>
            <numerusform>%1 % done, about %n second left</numerusform>
            <numerusform>%1 % done, about %n seconds left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 % done, about %n minute(s) left</source>
        <translation>
            <numerusform>%1 % done, about %n minute left</numerusform>
            <numerusform>%1 % done, about %n minutes left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::TasksPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES">
<context>
    <name>glenoid::AccuracyPanel</name>
    <message>
        <source>There is no reference of this kind: %1</source>
        <translation>No hay referencia de este tipo: %1</translation>
    </message>
    <message>
        <source>Within 5 ms, %1 is nearest: %2 of %3 error, %4 a step.</source>
        <translation>Dentro de 5 ms, lo más cercano es: %1; error de %3 de %2, %4 por paso.</translation>
    </message>
    <message>
        <source>No setting stays within 5 ms.</source>
        <translation>Ningún ajuste cabe en 5 ms.</translation>
    </message>
    <message>
        <source>Run a study, and each setting becomes a point: the nearer to the lower left the better.</source>
        <translation>Haga un estudio y cada ajuste será un punto: cuanto más abajo y a la izquierda, mejor.</translation>
    </message>
    <message>
        <source>Point at a setting to see what it is; click it to choose it.</source>
        <translation>Señale un ajuste para ver qué es; pulse sobre él para elegirlo.</translation>
    </message>
    <message>
        <source>No error can be given: %1.</source>
        <translation>No se puede dar un error: %1.</translation>
    </message>
    <message>
        <source>%1 of %2 error, largest for %3; %4 a step, %5 in 95 of 100.</source>
        <translation>Error de %2 de %1, el mayor en %3; %4 por paso, %5 en 95 de cada 100.</translation>
    </message>
    <message>
        <source>That is less than the reference’s own error.</source>
        <translation>Es menos que el error propio de la referencia.</translation>
    </message>
    <message>
        <source>Its time is a guess until times are taken.</source>
        <translation>Su tiempo es una estimación hasta que se midan los tiempos.</translation>
    </message>
    <message>
        <source>No scenario can say it, so it cannot be applied.</source>
        <translation>Ningún escenario puede expresarlo, así que no se puede aplicar.</translation>
    </message>
    <message>
        <source>%1 is less than twice the reference’s own error, %2: nothing can be told apart there.</source>
        <translation>%1 es menos que el doble del error propio de la referencia, %2: ahí no se puede distinguir nada.</translation>
    </message>
    <message>
        <source>No setting is that accurate.</source>
        <translation>Ningún ajuste es tan exacto.</translation>
    </message>
    <message>
        <source>No setting stays within %1.</source>
        <translation>Ningún ajuste cabe en %1.</translation>
    </message>
    <message>
        <source>Read the studied scene</source>
        <translation>Leer la escena estudiada</translation>
    </message>
    <message>
        <source>Prepare the setting</source>
        <translation>Preparar el ajuste</translation>
    </message>
    <message>
        <source>The scene has this setting already.</source>
        <translation>La escena ya tiene este ajuste.</translation>
    </message>
    <message>
        <source>%1 Undo brings back what was.</source>
        <translation>%1 Deshacer devuelve lo que había.</translation>
    </message>
    <message>
        <source>Before: the scene as it was studied</source>
        <translation>Antes: la escena tal como se estudió</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Después: %1</translation>
    </message>
    <message>
        <source>&amp;Error of</source>
        <translation>&amp;Error de</translation>
    </message>
    <message>
        <source>a&amp;gainst</source>
        <translation>&amp;frente a</translation>
    </message>
    <message>
        <source>Which error is shown</source>
        <translation>Qué error se muestra</translation>
    </message>
    <message>
        <source>With what settings are compared</source>
        <translation>Con qué se comparan los ajustes</translation>
    </message>
    <message>
        <source>Most accurate within</source>
        <translation>El más exacto dentro de</translation>
    </message>
    <message>
        <source>Fastest that reaches</source>
        <translation>El más rápido que alcanza</translation>
    </message>
    <message>
        <source>How a setting is chosen</source>
        <translation>Cómo se elige un ajuste</translation>
    </message>
    <message>
        <source>Budget or accuracy</source>
        <translation>Presupuesto o exactitud</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Elegir</translation>
    </message>
    <message>
        <source>Choose the setting that this asks for</source>
        <translation>Elegir el ajuste que esto pide</translation>
    </message>
    <message>
        <source>&amp;Apply to the scene</source>
        <translation>&amp;Aplicar a la escena</translation>
    </message>
    <message>
        <source>Let the scene run with the chosen setting; can be undone</source>
        <translation>Hacer que la escena use el ajuste elegido; se puede deshacer</translation>
    </message>
    <message>
        <source>&amp;Before and after</source>
        <translation>An&amp;tes y después</translation>
    </message>
    <message>
        <source>Draw the same moment of the run with the scene’s setting and with the chosen one, side by side</source>
        <translation>Dibujar el mismo momento con el ajuste de la escena y con el elegido, uno junto a otro</translation>
    </message>
    <message>
        <source>a&amp;t</source>
        <translation>e&amp;n</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Moment of the run that is drawn</source>
        <translation>Momento que se dibuja</translation>
    </message>
    <message>
        <source>Error beside computing time, a point for each setting</source>
        <translation>Error frente a tiempo de cálculo, un punto por ajuste</translation>
    </message>
    <message>
        <source>The arrow keys go through the settings, Enter chooses one</source>
        <translation>Las flechas recorren los ajustes, Intro elige uno</translation>
    </message>
    <message>
        <source>It has no error of %1 against this reference; %2 a step, %3 in 95 of 100.</source>
        <translation>No tiene error de %1 frente a esta referencia; %2 por paso, %3 en 95 de cada 100.</translation>
    </message>
    <message>
        <source>%1 of %2 error; %3 a step, %4 in 95 of 100.</source>
        <translation>Error de %2 de %1; %3 por paso, %4 en 95 de cada 100.</translation>
    </message>
</context>
<context>
    <name>glenoid::AccuracyPlot</name>
    <message>
        <source>Error of %1, mm</source>
        <translation>Error de %1, mm</translation>
    </message>
    <message>
        <source>Error of %1, N</source>
        <translation>Error de %1, N</translation>
    </message>
    <message>
        <source>Computing time for %1 ms of simulated time, ms</source>
        <translation>Tiempo de cálculo por %1 ms de tiempo simulado, ms</translation>
    </message>
    <message>
        <source>%1 (real time)</source>
        <translation>%1 (tiempo real)</translation>
    </message>
    <message>
        <source>no other is both faster and nearer</source>
        <translation>ninguno es a la vez más rápido y más cercano</translation>
    </message>
</context>
<context>
    <name>glenoid::Anatomy</name>
    <message>
        <source>Acromial part of the deltoid</source>
        <translation>Deltoides, porción acromial</translation>
    </message>
    <message>
        <source>Acromion (end on the acromion)</source>
        <translation>Acromion (extremo en el acromion)</translation>
    </message>
    <message>
        <source>Acromion (roof of the shoulder)</source>
        <translation>Acromion (techo del hombro)</translation>
    </message>
    <message>
        <source>Acromion, angulus anterior (front corner)</source>
        <translation>Acromion, angulus anterior (esquina anterior)</translation>
    </message>
    <message>
        <source>Acromion, apex (front tip of the acromion)</source>
        <translation>Acromion, apex (punta anterior del acromion)</translation>
    </message>
    <message>
        <source>Acromion, margo lateralis (side edge)</source>
        <translation>Acromion, margo lateralis (borde lateral)</translation>
    </message>
    <message>
        <source>Angulus acromii (acromial angle)</source>
        <translation>Angulus acromii (ángulo del acromion)</translation>
    </message>
    <message>
        <source>Angulus acromii (acromial angle, AA)</source>
        <translation>Angulus acromii (ángulo del acromion, AA)</translation>
    </message>
    <message>
        <source>Angulus inferior (lower tip, AI)</source>
        <translation>Angulus inferior (punta inferior, AI)</translation>
    </message>
    <message>
        <source>Angulus superior (upper corner)</source>
        <translation>Angulus superior (esquina superior)</translation>
    </message>
    <message>
        <source>Apex processus coracoidei (coracoid tip)</source>
        <translation>Apex processus coracoidei (punta de la coracoides)</translation>
    </message>
    <message>
        <source>Apex processus coracoidei (coracoid tip, PC)</source>
        <translation>Apex processus coracoidei (punta de la coracoides, PC)</translation>
    </message>
    <message>
        <source>Area nuda capitis humeri (bare area)</source>
        <translation>Area nuda capitis humeri (área desnuda)</translation>
    </message>
    <message>
        <source>Articular cartilage</source>
        <translation>Cartílago articular</translation>
    </message>
    <message>
        <source>Biceps anchor</source>
        <translation>Anclaje del bíceps</translation>
    </message>
    <message>
        <source>Biceps tendon</source>
        <translation>Tendón del bíceps</translation>
    </message>
    <message>
        <source>Border on the arm</source>
        <translation>Borde en el brazo</translation>
    </message>
    <message>
        <source>Border on the trunk</source>
        <translation>Borde en el tronco</translation>
    </message>
    <message>
        <source>Bursa subacromialis (subacromial bursa)</source>
        <translation>Bursa subacromialis (bolsa subacromial)</translation>
    </message>
    <message>
        <source>Caput humeri (cartilage of the humeral head)</source>
        <translation>Caput humeri (cartílago de la cabeza humeral)</translation>
    </message>
    <message>
        <source>Caput humeri, apex (middle of the cartilage)</source>
        <translation>Caput humeri, apex (centro del cartílago)</translation>
    </message>
    <message>
        <source>Caput humeri, superior (top of the head)</source>
        <translation>Caput humeri, superior (parte alta de la cabeza)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis (centre of the glenoid)</source>
        <translation>Cavitas glenoidalis (centro de la glenoides)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis (glenoid cartilage)</source>
        <translation>Cavitas glenoidalis (cartílago de la glenoides)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis, anterior (front)</source>
        <translation>Cavitas glenoidalis, anterior (delante)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis, inferior (lower end)</source>
        <translation>Cavitas glenoidalis, inferior (extremo inferior)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis, posterior (back)</source>
        <translation>Cavitas glenoidalis, posterior (detrás)</translation>
    </message>
    <message>
        <source>Cavitas glenoidalis, superior (upper end)</source>
        <translation>Cavitas glenoidalis, superior (extremo superior)</translation>
    </message>
    <message>
        <source>Centrum capitis (centre of the humeral head, GH)</source>
        <translation>Centrum capitis (centro de la cabeza humeral, GH)</translation>
    </message>
    <message>
        <source>Clavicle</source>
        <translation>Clavícula</translation>
    </message>
    <message>
        <source>Clavicular part of the deltoid</source>
        <translation>Deltoides, porción clavicular</translation>
    </message>
    <message>
        <source>Coracoacromial ligament</source>
        <translation>Ligamento coracoacromial</translation>
    </message>
    <message>
        <source>Coracohumeral ligament</source>
        <translation>Ligamento coracohumeral</translation>
    </message>
    <message>
        <source>Cortical bone</source>
        <translation>Hueso cortical</translation>
    </message>
    <message>
        <source>Epicondylus lateralis (outer elbow, EL)</source>
        <translation>Epicondylus lateralis (codo, lado externo, EL)</translation>
    </message>
    <message>
        <source>Epicondylus medialis (inner elbow, EM)</source>
        <translation>Epicondylus medialis (codo, lado interno, EM)</translation>
    </message>
    <message>
        <source>Facies inferior (teres minor facet)</source>
        <translation>Facies inferior (faceta del redondo menor)</translation>
    </message>
    <message>
        <source>Facies media (infraspinatus facet)</source>
        <translation>Facies media (faceta del infraespinoso)</translation>
    </message>
    <message>
        <source>Facies superior (supraspinatus facet)</source>
        <translation>Facies superior (faceta del supraespinoso)</translation>
    </message>
    <message>
        <source>Finis (end in the biceps tendon)</source>
        <translation>Finis (extremo en el tendón del bíceps)</translation>
    </message>
    <message>
        <source>Finis distalis (distal end below the groove)</source>
        <translation>Finis distalis (extremo distal bajo la corredera)</translation>
    </message>
    <message>
        <source>Fossa supraspinata (hollow above the spine)</source>
        <translation>Fossa supraspinata (hueco sobre la espina)</translation>
    </message>
    <message>
        <source>Glenoid labrum</source>
        <translation>Labrum glenoideo</translation>
    </message>
    <message>
        <source>Humerus</source>
        <translation>Húmero</translation>
    </message>
    <message>
        <source>Infraspinatus</source>
        <translation>Infraespinoso</translation>
    </message>
    <message>
        <source>Insertio: tuberculum majus (insertion, middle facet)</source>
        <translation>Insertio: tuberculum majus (inserción, faceta media)</translation>
    </message>
    <message>
        <source>Insertio: tuberculum majus (insertion, superior facet)</source>
        <translation>Insertio: tuberculum majus (inserción, faceta superior)</translation>
    </message>
    <message>
        <source>Insertio: tuberculum minus (insertion, lesser tubercle)</source>
        <translation>Insertio: tuberculum minus (inserción, tubérculo menor)</translation>
    </message>
    <message>
        <source>Insertion on the deltoid tuberosity</source>
        <translation>Inserción en la tuberosidad deltoidea</translation>
    </message>
    <message>
        <source>Intervallum rotatorum (rotator interval)</source>
        <translation>Intervallum rotatorum (intervalo de los rotadores)</translation>
    </message>
    <message>
        <source>Labrum</source>
        <translation>Labrum</translation>
    </message>
    <message>
        <source>Labrum glenoidale, basis (base on the glenoid rim)</source>
        <translation>Labrum glenoidale, basis (base en el borde de la glenoides)</translation>
    </message>
    <message>
        <source>Labrum glenoidale, pars superior (biceps anchor)</source>
        <translation>Labrum glenoidale, pars superior (anclaje del bíceps)</translation>
    </message>
    <message>
        <source>Labrum tendon</source>
        <translation>Tendón del labrum</translation>
    </message>
    <message>
        <source>Muscle, relaxed</source>
        <translation>Músculo relajado</translation>
    </message>
    <message>
        <source>Origin on the acromion</source>
        <translation>Origen en el acromion</translation>
    </message>
    <message>
        <source>Origin on the clavicle</source>
        <translation>Origen en la clavícula</translation>
    </message>
    <message>
        <source>Origin on the scapular spine</source>
        <translation>Origen en la espina de la escápula</translation>
    </message>
    <message>
        <source>Origo: fossa infraspinata (origin below the spine)</source>
        <translation>Origo: fossa infraspinata (origen bajo la espina)</translation>
    </message>
    <message>
        <source>Origo: fossa subscapularis (origin in front)</source>
        <translation>Origo: fossa subscapularis (origen anterior)</translation>
    </message>
    <message>
        <source>Origo: fossa supraspinata (origin above the spine)</source>
        <translation>Origo: fossa supraspinata (origen sobre la espina)</translation>
    </message>
    <message>
        <source>Pars intertubercularis (part in the groove)</source>
        <translation>Pars intertubercularis (porción en la corredera)</translation>
    </message>
    <message>
        <source>Pars intraarticularis (part over the head)</source>
        <translation>Pars intraarticularis (porción sobre la cabeza)</translation>
    </message>
    <message>
        <source>Processus coracoideus (coracoid)</source>
        <translation>Processus coracoideus (apófisis coracoides)</translation>
    </message>
    <message>
        <source>Processus coracoideus (end on the coracoid)</source>
        <translation>Processus coracoideus (extremo en la coracoides)</translation>
    </message>
    <message>
        <source>Radix (root in the labrum)</source>
        <translation>Radix (raíz en el labrum)</translation>
    </message>
    <message>
        <source>Right shoulder</source>
        <translation>Hombro derecho</translation>
    </message>
    <message>
        <source>Right shoulder with deltoid and skin</source>
        <translation>Hombro derecho con deltoides y piel</translation>
    </message>
    <message>
        <source>Scapula</source>
        <translation>Escápula</translation>
    </message>
    <message>
        <source>Septum to the clavicular part</source>
        <translation>Tabique con la porción clavicular</translation>
    </message>
    <message>
        <source>Septum to the spinal part</source>
        <translation>Tabique con la porción espinal</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Piel</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Piel y grasa</translation>
    </message>
    <message>
        <source>Spina scapulae (spine of the scapula)</source>
        <translation>Spina scapulae (espina de la escápula)</translation>
    </message>
    <message>
        <source>Spinal part of the deltoid</source>
        <translation>Deltoides, porción espinal</translation>
    </message>
    <message>
        <source>Subcutaneous fat</source>
        <translation>Grasa subcutánea</translation>
    </message>
    <message>
        <source>Subscapularis</source>
        <translation>Subescapular</translation>
    </message>
    <message>
        <source>Sulcus intertubercularis (bicipital groove)</source>
        <translation>Sulcus intertubercularis (corredera bicipital)</translation>
    </message>
    <message>
        <source>Sulcus intertubercularis, inferior (lower end of the groove)</source>
        <translation>Sulcus intertubercularis, inferior (extremo inferior de la corredera)</translation>
    </message>
    <message>
        <source>Sulcus intertubercularis, medius (middle of the groove)</source>
        <translation>Sulcus intertubercularis, medius (mitad de la corredera)</translation>
    </message>
    <message>
        <source>Sulcus intertubercularis, superior (upper end of the groove)</source>
        <translation>Sulcus intertubercularis, superior (extremo superior de la corredera)</translation>
    </message>
    <message>
        <source>Supraspinatus</source>
        <translation>Supraespinoso</translation>
    </message>
    <message>
        <source>Tendo (tendon)</source>
        <translation>Tendo (tendón)</translation>
    </message>
    <message>
        <source>Tendon of the long head of the biceps</source>
        <translation>Tendón de la cabeza larga del bíceps</translation>
    </message>
    <message>
        <source>Tendon of the rotator cuff</source>
        <translation>Tendón del manguito de los rotadores</translation>
    </message>
    <message>
        <source>Transverse humeral ligament</source>
        <translation>Ligamento humeral transverso</translation>
    </message>
    <message>
        <source>Trigonum spinae (root of the spine, TS)</source>
        <translation>Trigonum spinae (raíz de la espina, TS)</translation>
    </message>
    <message>
        <source>Tubercula (end on both tubercles)</source>
        <translation>Tubercula (extremo en ambos tubérculos)</translation>
    </message>
    <message>
        <source>Tuberculum majus (end on the greater tubercle)</source>
        <translation>Tuberculum majus (extremo en el tubérculo mayor)</translation>
    </message>
    <message>
        <source>Tuberculum majus (greater tubercle)</source>
        <translation>Tuberculum majus (tubérculo mayor)</translation>
    </message>
    <message>
        <source>Tuberculum majus, apex (top of the greater tubercle)</source>
        <translation>Tuberculum majus, apex (cima del tubérculo mayor)</translation>
    </message>
    <message>
        <source>Tuberculum majus, facies inferior (teres minor facet)</source>
        <translation>Tuberculum majus, facies inferior (faceta del redondo menor)</translation>
    </message>
    <message>
        <source>Tuberculum majus, facies media (infraspinatus facet)</source>
        <translation>Tuberculum majus, facies media (faceta del infraespinoso)</translation>
    </message>
    <message>
        <source>Tuberculum majus, facies superior (supraspinatus facet)</source>
        <translation>Tuberculum majus, facies superior (faceta del supraespinoso)</translation>
    </message>
    <message>
        <source>Tuberculum majus, lateralis (side of the greater tubercle)</source>
        <translation>Tuberculum majus, lateralis (lado del tubérculo mayor)</translation>
    </message>
    <message>
        <source>Tuberculum minus (end on the lesser tubercle)</source>
        <translation>Tuberculum minus (extremo en el tubérculo menor)</translation>
    </message>
    <message>
        <source>Tuberculum minus (front of the lesser tubercle)</source>
        <translation>Tuberculum minus (parte anterior del tubérculo menor)</translation>
    </message>
    <message>
        <source>Tuberculum minus (lesser tubercle)</source>
        <translation>Tuberculum minus (tubérculo menor)</translation>
    </message>
    <message>
        <source>Tuberculum minus, facies (subscapularis facet)</source>
        <translation>Tuberculum minus, facies (faceta del subescapular)</translation>
    </message>
    <message>
        <source>Tuberculum supraglenoidale (biceps anchor)</source>
        <translation>Tuberculum supraglenoidale (anclaje del bíceps)</translation>
    </message>
    <message>
        <source>Tuberositas deltoidea (deltoid tuberosity)</source>
        <translation>Tuberositas deltoidea (tuberosidad deltoidea)</translation>
    </message>
    <message>
        <source>Collateral ligament</source>
        <translation>Ligamento colateral</translation>
    </message>
    <message>
        <source>Femur</source>
        <translation>Fémur</translation>
    </message>
    <message>
        <source>Lateral collateral ligament</source>
        <translation>Ligamento colateral lateral</translation>
    </message>
    <message>
        <source>Medial collateral ligament</source>
        <translation>Ligamento colateral medial</translation>
    </message>
    <message>
        <source>Right elbow</source>
        <translation>Codo derecho</translation>
    </message>
    <message>
        <source>Right knee</source>
        <translation>Rodilla derecha</translation>
    </message>
    <message>
        <source>Tibia and fibula</source>
        <translation>Tibia y peroné</translation>
    </message>
    <message>
        <source>Ulna</source>
        <translation>Cúbito</translation>
    </message>
    <message>
        <source>Ulnar collateral ligament</source>
        <translation>Ligamento colateral cubital</translation>
    </message>
    <message>
        <source>Right shoulder with capsule</source>
        <translation>Hombro derecho con cápsula</translation>
    </message>
    <message>
        <source>Teres minor</source>
        <translation>Redondo menor</translation>
    </message>
    <message>
        <source>Capsule of the shoulder joint</source>
        <translation>Cápsula de la articulación del hombro</translation>
    </message>
    <message>
        <source>Superior glenohumeral ligament</source>
        <translation>Ligamento glenohumeral superior</translation>
    </message>
    <message>
        <source>Middle glenohumeral ligament</source>
        <translation>Ligamento glenohumeral medio</translation>
    </message>
    <message>
        <source>Inferior glenohumeral ligament</source>
        <translation>Ligamento glenohumeral inferior</translation>
    </message>
    <message>
        <source>Glenohumeral ligaments</source>
        <translation>Ligamentos glenohumerales</translation>
    </message>
    <message>
        <source>Origo: margo lateralis scapulae (origin on the lateral border)</source>
        <translation>Origo: margo lateralis scapulae (origen en el borde lateral)</translation>
    </message>
    <message>
        <source>Insertio: tuberculum majus (insertion, inferior facet)</source>
        <translation>Insertio: tuberculum majus (inserción, faceta inferior)</translation>
    </message>
    <message>
        <source>Septum to the infraspinatus</source>
        <translation>Tabique con el infraespinoso</translation>
    </message>
    <message>
        <source>Collum scapulae (end on the neck of the scapula)</source>
        <translation>Collum scapulae (extremo en el cuello de la escápula)</translation>
    </message>
    <message>
        <source>Collum anatomicum (end on the anatomical neck)</source>
        <translation>Collum anatomicum (extremo en el cuello anatómico)</translation>
    </message>
    <message>
        <source>Recessus axillaris (axillary pouch)</source>
        <translation>Recessus axillaris (receso axilar)</translation>
    </message>
    <message>
        <source>Under the supraspinatus</source>
        <translation>Bajo el supraespinoso</translation>
    </message>
    <message>
        <source>Under the infraspinatus</source>
        <translation>Bajo el infraespinoso</translation>
    </message>
    <message>
        <source>Under the subscapularis</source>
        <translation>Bajo el subescapular</translation>
    </message>
    <message>
        <source>Under the teres minor</source>
        <translation>Bajo el redondo menor</translation>
    </message>
    <message>
        <source>Under the coracohumeral ligament</source>
        <translation>Bajo el ligamento coracohumeral</translation>
    </message>
    <message>
        <source>Facies capsularis (side on the capsule)</source>
        <translation>Facies capsularis (cara sobre la cápsula)</translation>
    </message>
    <message>
        <source>Labrum glenoidale (end at the labrum)</source>
        <translation>Labrum glenoidale (extremo en el rodete)</translation>
    </message>
    <message>
        <source>Porta posterior (posterior portal, soft spot)</source>
        <translation>Porta posterior (portal posterior, punto blando)</translation>
    </message>
    <message>
        <source>Porta anterior (anterior portal, rotator interval)</source>
        <translation>Porta anterior (portal anterior, intervalo de los rotadores)</translation>
    </message>
    <message>
        <source>Porta lateralis (lateral portal)</source>
        <translation>Porta lateralis (portal lateral)</translation>
    </message>
</context>
<context>
    <name>glenoid::AuthorDocks</name>
    <message>
        <source>&amp;Move a cage</source>
        <translation>&amp;Mover una jaula</translation>
    </message>
    <message>
        <source>Pick and drag the handles of the cage around the chosen part</source>
        <translation>Seleccionar y arrastrar los tiradores de la jaula de la pieza elegida</translation>
    </message>
    <message>
        <source>By &amp;click</source>
        <translation>Con un &amp;clic</translation>
    </message>
    <message>
        <source>Pick what is under the cursor</source>
        <translation>Seleccionar lo que hay bajo el cursor</translation>
    </message>
    <message>
        <source>By &amp;box</source>
        <translation>Con &amp;rectángulo</translation>
    </message>
    <message>
        <source>Pick what lies in a rectangle</source>
        <translation>Seleccionar lo que queda dentro de un rectángulo</translation>
    </message>
    <message>
        <source>By &amp;lasso</source>
        <translation>Con &amp;lazo</translation>
    </message>
    <message>
        <source>Pick what a drawn line goes around</source>
        <translation>Seleccionar lo que rodea una línea dibujada</translation>
    </message>
    <message>
        <source>By b&amp;rush</source>
        <translation>Con &amp;pincel</translation>
    </message>
    <message>
        <source>Paint over what shall be picked; [ and ] change the brush</source>
        <translation>Pintar sobre lo que se quiere seleccionar; [ y ] cambian el pincel</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Ampliar</translation>
    </message>
    <message>
        <source>&amp;Shrink</source>
        <translation>&amp;Reducir</translation>
    </message>
    <message>
        <source>C&amp;onnected</source>
        <translation>C&amp;onectados</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ninguno</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Invertir</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>Pincel más pe&amp;queño</translation>
    </message>
    <message>
        <source>Make the brush smaller</source>
        <translation>Hacer el pincel más pequeño</translation>
    </message>
    <message>
        <source>L&amp;arger brush</source>
        <translation>Pincel más &amp;grande</translation>
    </message>
    <message>
        <source>Make the brush larger</source>
        <translation>Hacer el pincel más grande</translation>
    </message>
    <message>
        <source>&amp;Author</source>
        <translation>A&amp;utor</translation>
    </message>
    <message>
        <source>Author&apos;s tools</source>
        <translation>Herramientas del autor</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Make a bod&amp;y</source>
        <translation>Crear un c&amp;uerpo</translation>
    </message>
    <message>
        <source>Show how the chosen part collides and deforms, and change it</source>
        <translation>Mostrar cómo colisiona y se deforma la pieza elegida, y cambiarlo</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>&amp;Pick on a part</source>
        <translation>&amp;Elegir sobre una pieza</translation>
    </message>
    <message>
        <source>Pick triangles or nodes of a part with the mouse; Shift adds, Ctrl takes away, Alt goes through</source>
        <translation>Elegir con el ratón triángulos o nodos de una pieza; Mayús añade, Ctrl quita, Alt atraviesa</translation>
    </message>
    <message>
        <source>&amp;Triangles</source>
        <translation>&amp;Triángulos</translation>
    </message>
    <message>
        <source>Pick triangles of a surface, for regions</source>
        <translation>Elegir triángulos de una superficie, para regiones</translation>
    </message>
    <message>
        <source>N&amp;odes</source>
        <translation>N&amp;odos</translation>
    </message>
    <message>
        <source>Pick nodes of a soft part&apos;s cells, which springs will hold</source>
        <translation>Elegir nodos de las celdas de una pieza blanda, que sujetarán muelles</translation>
    </message>
    <message>
        <source>Select one ring more</source>
        <translation>Seleccionar un anillo más</translation>
    </message>
    <message>
        <source>Select one ring less</source>
        <translation>Seleccionar un anillo menos</translation>
    </message>
    <message>
        <source>Select the whole piece that is connected</source>
        <translation>Seleccionar todo el trozo conectado</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>No seleccionar nada</translation>
    </message>
    <message>
        <source>Select all others</source>
        <translation>Seleccionar todo lo demás</translation>
    </message>
</context>
<context>
    <name>glenoid::AuthorEdits</name>
    <message>
        <source>Change the region “%1”</source>
        <translation>Cambiar la región «%1»</translation>
    </message>
    <message>
        <source>Rename a region to “%1”</source>
        <translation>Cambiar el nombre de una región a «%1»</translation>
    </message>
    <message>
        <source>Remove the region “%1”</source>
        <translation>Quitar la región «%1»</translation>
    </message>
    <message>
        <source>Uncouple %1 from %2</source>
        <translation>Desacoplar %1 de %2</translation>
    </message>
    <message>
        <source>Say why two parts are coupled</source>
        <translation>Decir por qué se acoplan dos piezas</translation>
    </message>
    <message>
        <source>Change the damping of a coupling</source>
        <translation>Cambiar la amortiguación de un acoplamiento</translation>
    </message>
    <message>
        <source>Make the region “%1”</source>
        <translation>Crear la región «%1»</translation>
    </message>
    <message>
        <source>Couple %1 to %2</source>
        <translation>Acoplar %1 a %2</translation>
    </message>
    <message>
        <source>Make the body of %1</source>
        <translation>Crear el cuerpo de %1</translation>
    </message>
    <message>
        <source>Make %1 of “%2”</source>
        <translation>Hacer %1 de «%2»</translation>
    </message>
    <message>
        <source>Switch the collision of %1 and %2 off</source>
        <translation>Desactivar la colisión entre %1 y %2</translation>
    </message>
    <message>
        <source>Move the cage of %1</source>
        <translation>Mover la jaula de %1</translation>
    </message>
    <message>
        <source>Remove the cage of %1</source>
        <translation>Quitar la jaula de %1</translation>
    </message>
    <message>
        <source>Pick other nodes for the coupling of %1 to %2</source>
        <translation>Elegir otros nodos para el acoplamiento de %1 con %2</translation>
    </message>
</context>
<context>
    <name>glenoid::Authoring</name>
    <message>
        <source>Grow the selection</source>
        <translation>Ampliar la selección</translation>
    </message>
    <message>
        <source>Shrink the selection</source>
        <translation>Reducir la selección</translation>
    </message>
    <message>
        <source>Select what is connected</source>
        <translation>Seleccionar lo que está conectado</translation>
    </message>
    <message>
        <source>Invert the selection</source>
        <translation>Invertir la selección</translation>
    </message>
    <message>
        <source>Select no triangles</source>
        <translation>No seleccionar ningún triángulo</translation>
    </message>
    <message numerus="yes">
        <source>Select %n triangle(s)</source>
        <translation>
            <numerusform>Seleccionar %n triángulo</numerusform>
            <numerusform>Seleccionar %n triángulos</numerusform>
        </translation>
    </message>
    <message>
        <source>Select no nodes</source>
        <translation>No seleccionar ningún nodo</translation>
    </message>
    <message numerus="yes">
        <source>Select %n node(s)</source>
        <translation>
            <numerusform>Seleccionar %n nodo</numerusform>
            <numerusform>Seleccionar %n nodos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::BodyPanel</name>
    <message>
        <source>No part is chosen.</source>
        <translation>No hay ninguna pieza elegida.</translation>
    </message>
    <message>
        <source>%1 (library)</source>
        <translation>%1 (biblioteca)</translation>
    </message>
    <message>
        <source>Paint on the part in the view where the collision surface shall be finer, then mark it here.</source>
        <translation>Pinte sobre la pieza en la vista donde la superficie de colisión deba ser más fina y márquelo aquí.</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) matter more than the others.</source>
        <translation>
            <numerusform>%n triángulo importa más que los demás.</numerusform>
            <numerusform>%n triángulos importan más que los demás.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are seen</source>
        <translation>
            <numerusform>%n triángulo se ve</numerusform>
            <numerusform>%n triángulos se ven</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) collide</source>
        <translation>
            <numerusform>%n triángulo colisiona</numerusform>
            <numerusform>%n triángulos colisionan</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n tetrahedron(s) deform</source>
        <translation>
            <numerusform>%n tetraedro se deforma</numerusform>
            <numerusform>%n tetraedros se deforman</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing deforms: the part is rigid</source>
        <translation>Nada se deforma: la pieza es rígida</translation>
    </message>
    <message>
        <source>Making the meshes…</source>
        <translation>Creando las mallas…</translation>
    </message>
    <message>
        <source>This is what the part has. Move a slider to try another body.</source>
        <translation>Esto es lo que tiene la pieza. Mueva un deslizador para probar otro cuerpo.</translation>
    </message>
    <message>
        <source>The collision surface leaves the visual one by %1 mm at most, %2 mm on average; its volume is off by %3 %.</source>
        <translation>La superficie de colisión se aparta de la visual %1 mm como máximo, %2 mm por término medio; su volumen difiere un %3 %.</translation>
    </message>
    <message>
        <source>%1 with %2; tissue fills %3 % of them, the emptiest %4 %.</source>
        <translation>%1 con %2; el tejido los llena al %3 %, el más vacío al %4 %.</translation>
    </message>
    <message numerus="yes">
        <source>%n tetrahedron(s)</source>
        <translation>
            <numerusform>%n tetraedro</numerusform>
            <numerusform>%n tetraedros</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n nodo</numerusform>
            <numerusform>%n nodos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The tetrahedra fall into %n piece(s): take smaller cells.</source>
        <translation>
            <numerusform>Los tetraedros forman %n trozo: tome celdas más pequeñas.</numerusform>
            <numerusform>Los tetraedros se separan en %n trozos: tome celdas más pequeñas.</numerusform>
        </translation>
    </message>
    <message>
        <source>A region on the collision surface that is in use would be lost; take more triangles there.</source>
        <translation>Se perdería una región de la superficie de colisión que está en uso; ponga más triángulos ahí.</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Where triangles matter</source>
        <translation>Dónde importan los triángulos</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Clase:</translation>
    </message>
    <message>
        <source>Collision triangles:</source>
        <translation>Triángulos de colisión:</translation>
    </message>
    <message>
        <source>Cell size:</source>
        <translation>Tamaño de celda:</translation>
    </message>
    <message>
        <source>Material:</source>
        <translation>Material:</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>rígida</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>blanda</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Cells along the part&apos;s own axes</source>
        <translation>Celdas según los ejes propios de la pieza</translation>
    </message>
    <message>
        <source>Spares a flat oblique part the stairs that the world&apos;s axes would cut</source>
        <translation>Evita a una pieza plana y oblicua los escalones que cortarían los ejes del mundo</translation>
    </message>
    <message>
        <source>Own copy</source>
        <translation>Copia propia</translation>
    </message>
    <message>
        <source>Give this part a material of its own, to be changed without changing others</source>
        <translation>Dar a esta pieza un material propio, para cambiarlo sin cambiar otras</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marcar</translation>
    </message>
    <message>
        <source>The selected triangles of the visual surface matter</source>
        <translation>Los triángulos seleccionados de la superficie visual importan</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>No triangle matters more than another</source>
        <translation>Ningún triángulo importa más que otro</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Give the part this body; its cage and the proof of the start go</source>
        <translation>Dar este cuerpo a la pieza; su jaula y la comprobación del inicio desaparecen</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Volver</translation>
    </message>
    <message>
        <source>Back to what the part has</source>
        <translation>Volver a lo que tiene la pieza</translation>
    </message>
    <message>
        <source>Collision triangles</source>
        <translation>Triángulos de colisión</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Tamaño de celda</translation>
    </message>
    <message>
        <source>Kind of the part</source>
        <translation>Clase de la pieza</translation>
    </message>
    <message>
        <source>Material of the part</source>
        <translation>Material de la pieza</translation>
    </message>
    <message>
        <source>How much more the marked triangles matter</source>
        <translation>Cuánto más importan los triángulos marcados</translation>
    </message>
    <message>
        <source>Visual surface</source>
        <translation>Superficie visual</translation>
    </message>
    <message>
        <source>Collision surface</source>
        <translation>Superficie de colisión</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedros</translation>
    </message>
    <message>
        <source>The part is about %1 mm thick and will add about %2 ms to a step, without contacts.</source>
        <translation>La pieza tiene unos %1 mm de grosor y añadirá unos %2 ms a un paso, sin contactos.</translation>
    </message>
</context>
<context>
    <name>glenoid::CagePanel</name>
    <message>
        <source>Stopped; nothing was changed.</source>
        <translation>Detenido; no se ha cambiado nada.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>A cage goes around a soft part with tetrahedra. Choose one among the parts.</source>
        <translation>Una jaula rodea una pieza blanda con tetraedros. Elija una entre las piezas.</translation>
    </message>
    <message>
        <source>This part has no cage yet.</source>
        <translation>Esta pieza aún no tiene jaula.</translation>
    </message>
    <message numerus="yes">
        <source>%n handle(s); pick some in the view to move them.</source>
        <translation>
            <numerusform>%n tirador; selecciónelo en la vista para moverlo.</numerusform>
            <numerusform>%n tiradores; seleccione algunos en la vista para moverlos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n handle(s) picked. Their mean shift from rest:</source>
        <translation>
            <numerusform>%n tirador seleccionado. Su desplazamiento desde el reposo:</numerusform>
            <numerusform>%n tiradores seleccionados. Su desplazamiento medio desde el reposo:</numerusform>
        </translation>
    </message>
    <message>
        <source>The start has not been proved.</source>
        <translation>El inicio no se ha comprobado.</translation>
    </message>
    <message>
        <source>The proof is of an older start; prove it again.</source>
        <translation>La comprobación es de un inicio anterior; compruébelo de nuevo.</translation>
    </message>
    <message>
        <source>Proved: no triangles cut among %1, least volume ratio %2.</source>
        <translation>Comprobado: ningún triángulo se corta entre %1; menor razón de volumen %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of parts</source>
        <translation>
            <numerusform>%n par de piezas</numerusform>
            <numerusform>%n pares de piezas</numerusform>
        </translation>
    </message>
    <message>
        <source>The proof fails: %1, least volume ratio %2.</source>
        <translation>La comprobación falla: %1; menor razón de volumen %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n cut(s)</source>
        <translation>
            <numerusform>%n corte</numerusform>
            <numerusform>%n cortes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>No two parts that may collide overlap at the start.</source>
        <translation>Al inicio no se solapan dos piezas que puedan colisionar.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of parts overlap at the start.</source>
        <translation>
            <numerusform>%n par de piezas se solapa al inicio.</numerusform>
            <numerusform>%n pares de piezas se solapan al inicio.</numerusform>
        </translation>
    </message>
    <message>
        <source>Making the cage…</source>
        <translation>Creando la jaula…</translation>
    </message>
    <message>
        <source>Make a cage around %1</source>
        <translation>Crear una jaula alrededor de %1</translation>
    </message>
    <message>
        <source>Moving cages apart…</source>
        <translation>Separando las jaulas…</translation>
    </message>
    <message numerus="yes">
        <source>Moving cages apart: %n pair(s) still overlap.</source>
        <translation>
            <numerusform>Separando las jaulas: %n par aún se solapa.</numerusform>
            <numerusform>Separando las jaulas: %n pares aún se solapan.</numerusform>
        </translation>
    </message>
    <message>
        <source>Separate the start by cages</source>
        <translation>Separar el inicio con jaulas</translation>
    </message>
    <message>
        <source>Nothing overlaps any more; the surface moved by %1 mm at most.</source>
        <translation>Ya no se solapa nada; la superficie se ha movido %1 mm como máximo.</translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) still overlap; move their cages by hand or allow more handles.</source>
        <translation>
            <numerusform>%n par aún se solapa; mueva sus jaulas a mano o permita más tiradores.</numerusform>
            <numerusform>%n pares aún se solapan; mueva sus jaulas a mano o permita más tiradores.</numerusform>
        </translation>
    </message>
    <message>
        <source>Counting every cut…</source>
        <translation>Contando todos los cortes…</translation>
    </message>
    <message>
        <source>Prove the start</source>
        <translation>Comprobar el inicio</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Jaula</translation>
    </message>
    <message>
        <source>Overlaps at the start</source>
        <translation>Solapamientos al inicio</translation>
    </message>
    <message>
        <source>Around:</source>
        <translation>Alrededor de:</translation>
    </message>
    <message>
        <source>Handles:</source>
        <translation>Tiradores:</translation>
    </message>
    <message>
        <source>Anterior:</source>
        <translation>Anterior:</translation>
    </message>
    <message>
        <source>Superior:</source>
        <translation>Superior:</translation>
    </message>
    <message>
        <source>Lateral:</source>
        <translation>Lateral:</translation>
    </message>
    <message>
        <source>Clearance:</source>
        <translation>Holgura:</translation>
    </message>
    <message>
        <source>Number of handles of a new cage</source>
        <translation>Número de tiradores de una jaula nueva</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Crear</translation>
    </message>
    <message>
        <source>Make a cage around this part; an old one goes</source>
        <translation>Crear una jaula alrededor de esta pieza; la anterior desaparece</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Put all handles back to rest</source>
        <translation>Devolver todos los tiradores al reposo</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Let the part start at rest</source>
        <translation>Dejar que la pieza empiece en reposo</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>Sugerir</translation>
    </message>
    <message>
        <source>Move cages until no two parts cut each other</source>
        <translation>Mover las jaulas hasta que ninguna pieza corte a otra</translation>
    </message>
    <message>
        <source>Prove</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Count every cut exactly and write the result into the joint</source>
        <translation>Contar todos los cortes con exactitud y anotar el resultado en la articulación</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Stop what is under way; nothing is changed then</source>
        <translation>Detener lo que está en marcha; entonces no se cambia nada</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Shift of the picked handles</source>
        <translation>Desplazamiento de los tiradores seleccionados</translation>
    </message>
    <message>
        <source>Clearance that a suggestion keeps</source>
        <translation>Holgura que mantiene una sugerencia</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profundidad</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Cortes</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Medial:</source>
        <translation>Medial:</translation>
    </message>
</context>
<context>
    <name>glenoid::CarriedText</name>
    <message>
        <source>Picked nodes of couplings became the nearest ones of the new cells: %1 now %2, moved by %3 mm at most.</source>
        <translation>Los nodos elegidos de los acoplamientos pasaron a ser los más cercanos de las celdas nuevas: de %1 quedan %2, movidos %3 mm como máximo.</translation>
    </message>
</context>
<context>
    <name>glenoid::CouplingPanel</name>
    <message>
        <source>Select the region “%1”</source>
        <translation>Seleccionar la región «%1»</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>Región nueva</translation>
    </message>
    <message>
        <source>%1 kPa per mm</source>
        <translation>%1 kPa por mm</translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) selected</source>
        <translation>
            <numerusform>%n triángulo seleccionado</numerusform>
            <numerusform>%n triángulos seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 mm², %3 % of the surface.</source>
        <translation>%1: %2 mm², %3 % de la superficie.</translation>
    </message>
    <message>
        <source>Nothing is selected. Paint on the part in the view, or take what is near.</source>
        <translation>No hay nada seleccionado. Pinte sobre la pieza en la vista o tome lo que está cerca.</translation>
    </message>
    <message>
        <source>The materials suggest %1 N/mm per cm²: the softer tissue&apos;s modulus over one cell.</source>
        <translation>Los materiales sugieren %1 N/mm por cm²: el módulo del tejido más blando entre el tamaño de una celda.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 con %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>Choose a coupling to see its figures.</source>
        <translation>Elija un acoplamiento para ver sus cifras.</translation>
    </message>
    <message>
        <source>Counting springs…</source>
        <translation>Contando los muelles…</translation>
    </message>
    <message>
        <source>%1 over %2 mm² (%3 % of the part), %4 N/mm in all. The region lies %5 mm from the other part on average, %6 mm at most.</source>
        <translation>%1 en %2 mm² (%3 % de la pieza), %4 N/mm en total. La región queda a %5 mm de la otra pieza por término medio, a %6 mm como máximo.</translation>
    </message>
    <message numerus="yes">
        <source>%n spring(s)</source>
        <translation>
            <numerusform>%n muelle</numerusform>
            <numerusform>%n muelles</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2 are bonded over %3 mm², %4 % of the smaller one and %5 % of what lies near. They need no collision.</source>
        <translation>%1 y %2 están unidas en %3 mm², el %4 % de la menor y el %5 % de lo que queda cerca. No necesitan colisión.</translation>
    </message>
    <message>
        <source>Switch their collision off</source>
        <translation>Desactivar su colisión</translation>
    </message>
    <message>
        <source>Select what is within %1 mm</source>
        <translation>Seleccionar lo que está a menos de %1 mm</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Regions of this part</source>
        <translation>Regiones de esta pieza</translation>
    </message>
    <message>
        <source>New coupling</source>
        <translation>Acoplamiento nuevo</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Pick on:</source>
        <translation>Seleccionar en:</translation>
    </message>
    <message>
        <source>Surface:</source>
        <translation>Superficie:</translation>
    </message>
    <message>
        <source>Couple to:</source>
        <translation>Acoplar a:</translation>
    </message>
    <message>
        <source>Near:</source>
        <translation>Cerca:</translation>
    </message>
    <message>
        <source>Stiffness:</source>
        <translation>Rigidez:</translation>
    </message>
    <message>
        <source>This means:</source>
        <translation>Es decir:</translation>
    </message>
    <message>
        <source>Why:</source>
        <translation>Por qué:</translation>
    </message>
    <message>
        <source>Damping:</source>
        <translation>Amortiguación:</translation>
    </message>
    <message>
        <source>visual</source>
        <translation>visual</translation>
    </message>
    <message>
        <source>collision</source>
        <translation>de colisión</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance to the other part</source>
        <translation>Distancia a la otra pieza</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nueva</translation>
    </message>
    <message>
        <source>Make a region of what is selected</source>
        <translation>Hacer una región de lo seleccionado</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>Fijar</translation>
    </message>
    <message>
        <source>The chosen region becomes what is selected</source>
        <translation>La región elegida pasa a ser lo seleccionado</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the chosen region; one that is in use stays</source>
        <translation>Quitar la región elegida; la que está en uso se queda</translation>
    </message>
    <message>
        <source> N/mm per cm²</source>
        <translation> N/mm por cm²</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Damping force per velocity, over the stiffness</source>
        <translation>Fuerza de amortiguación por velocidad, dividida por la rigidez</translation>
    </message>
    <message>
        <source>What joins the two, for people</source>
        <translation>Qué une a las dos, para las personas</translation>
    </message>
    <message>
        <source>Couple over the selection</source>
        <translation>Acoplar en la selección</translation>
    </message>
    <message>
        <source>Remove this coupling</source>
        <translation>Quitar este acoplamiento</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Región</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>Muelles</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Couplings of the joint</source>
        <translation>Acoplamientos de la articulación</translation>
    </message>
    <message>
        <source>Regions of the part</source>
        <translation>Regiones de la pieza</translation>
    </message>
    <message>
        <source>Stiffness per area</source>
        <translation>Rigidez por superficie</translation>
    </message>
    <message>
        <source>Damping of the coupling</source>
        <translation>Amortiguación del acoplamiento</translation>
    </message>
    <message>
        <source>Why the parts are coupled</source>
        <translation>Por qué se acoplan las piezas</translation>
    </message>
    <message>
        <source>Add the region “%1”</source>
        <translation>Añadir la región «%1»</translation>
    </message>
    <message>
        <source>Take the region “%1” away</source>
        <translation>Quitar la región «%1»</translation>
    </message>
    <message>
        <source>Keep what the region “%1” shares</source>
        <translation>Dejar lo que comparte la región «%1»</translation>
    </message>
    <message>
        <source>Only within what is selected</source>
        <translation>Solo dentro de lo seleccionado</translation>
    </message>
    <message>
        <source>Draw a lasso first: of what is near, only what lies in it is taken</source>
        <translation>Dibuje antes un lazo: de lo que está cerca solo se toma lo que queda dentro</translation>
    </message>
    <message>
        <source>The two touch each other</source>
        <translation>Las dos se tocan</translation>
    </message>
    <message>
        <source>Off: contact between these two parts is not looked for</source>
        <translation>Desactivado: no se busca contacto entre estas dos piezas</translation>
    </message>
    <message>
        <source>A region becomes the selection</source>
        <translation>La región pasa a ser la selección</translation>
    </message>
    <message>
        <source>A region is added to the selection</source>
        <translation>La región se añade a la selección</translation>
    </message>
    <message>
        <source>A region is taken from the selection</source>
        <translation>La región se quita de la selección</translation>
    </message>
    <message>
        <source>The selection keeps what a region shares</source>
        <translation>La selección conserva lo que comparte la región</translation>
    </message>
    <message>
        <source>What choosing a region does</source>
        <translation>Qué hace elegir una región</translation>
    </message>
    <message>
        <source>The materials suggest %1 N/mm: the softer tissue&apos;s modulus times the edge of a cell.</source>
        <translation>Los materiales sugieren %1 N/mm: el módulo del tejido más blando por la arista de una celda.</translation>
    </message>
    <message numerus="yes">
        <source>%n node(s)</source>
        <translation>
            <numerusform>%n nodo</numerusform>
            <numerusform>%n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source> N/mm per node</source>
        <translation> N/mm por nodo</translation>
    </message>
    <message>
        <source>Stiffness of each spring</source>
        <translation>Rigidez de cada muelle</translation>
    </message>
    <message>
        <source>%1 at picked nodes, %2 N/mm in all. They lie %3 mm from the other part on average, %4 mm at most.</source>
        <translation>%1 en nodos elegidos, %2 N/mm en total. Están a %3 mm de la otra pieza de media y a %4 mm como máximo.</translation>
    </message>
    <message>
        <source>Couple at the selected nodes</source>
        <translation>Acoplar en los nodos seleccionados</translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) selected</source>
        <translation>
            <numerusform>%n nodo seleccionado</numerusform>
            <numerusform>%n nodos seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>This part is rigid and has no nodes. Pick on a soft part.</source>
        <translation>Esta pieza es rígida y no tiene nodos. Elija sobre una pieza blanda.</translation>
    </message>
    <message>
        <source>Nothing is selected. Paint over the dots in the view, or take what is near.</source>
        <translation>No hay nada seleccionado. Pinte sobre los puntos de la vista o tome lo que está cerca.</translation>
    </message>
    <message>
        <source>%1: too few, or in a line. Three that do not lie in a line are needed.</source>
        <translation>%1: son muy pocos o están alineados. Hacen falta tres que no estén en una línea.</translation>
    </message>
    <message>
        <source>%1 of %2.</source>
        <translation>%1 de %2.</translation>
    </message>
    <message>
        <source>Select the nodes of a coupling</source>
        <translation>Seleccionar los nodos de un acoplamiento</translation>
    </message>
    <message>
        <source>These nodes cannot hold: three that do not lie in a line are needed.</source>
        <translation>Estos nodos no pueden sujetar: hacen falta tres que no estén en una línea.</translation>
    </message>
    <message>
        <source>%1 N/mm in all</source>
        <translation>%1 N/mm en total</translation>
    </message>
    <message>
        <source>What:</source>
        <translation>Qué:</translation>
    </message>
    <message>
        <source>triangles of its surface</source>
        <translation>triángulos de su superficie</translation>
    </message>
    <message>
        <source>nodes of its cells</source>
        <translation>nodos de sus celdas</translation>
    </message>
    <message>
        <source>Over triangles the parts are glued; at nodes a spring of its own holds each</source>
        <translation>Sobre triángulos las piezas quedan pegadas; en los nodos, cada uno lo sujeta un muelle propio</translation>
    </message>
    <message>
        <source>Select all that lies within this distance of the other part, or inside it</source>
        <translation>Seleccionar todo lo que está a esta distancia de la otra pieza o dentro de ella</translation>
    </message>
    <message>
        <source>Select its nodes</source>
        <translation>Seleccionar sus nodos</translation>
    </message>
    <message>
        <source>The nodes of the chosen coupling become the selection</source>
        <translation>Los nodos del acoplamiento elegido pasan a ser la selección</translation>
    </message>
    <message>
        <source>Set its nodes</source>
        <translation>Fijar sus nodos</translation>
    </message>
    <message>
        <source>The chosen coupling holds at the selected nodes from now on</source>
        <translation>El acoplamiento elegido sujeta desde ahora en los nodos seleccionados</translation>
    </message>
</context>
<context>
    <name>glenoid::Document</name>
    <message>
        <source>Change the stiffness of “%1”</source>
        <translation>Cambiar la rigidez de «%1»</translation>
    </message>
    <message>
        <source>Change the coupling “%1”</source>
        <translation>Cambiar el acoplamiento «%1»</translation>
    </message>
    <message>
        <source>Change the solver</source>
        <translation>Cambiar el método de cálculo</translation>
    </message>
</context>
<context>
    <name>glenoid::EffectPrices</name>
    <message>
        <source>Forces and stiffness</source>
        <translation>Fuerzas y rigidez</translation>
    </message>
    <message>
        <source>Factorization</source>
        <translation>Factorización</translation>
    </message>
    <message>
        <source>Free motion</source>
        <translation>Movimiento libre</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Superficies</translation>
    </message>
    <message>
        <source>Search for contacts</source>
        <translation>Búsqueda de contactos</translation>
    </message>
    <message>
        <source>Search for self-contacts</source>
        <translation>Búsqueda de autocontactos</translation>
    </message>
    <message>
        <source>Rows and islands</source>
        <translation>Filas e islas</translation>
    </message>
    <message>
        <source>Delassus matrix</source>
        <translation>Matriz de Delassus</translation>
    </message>
    <message>
        <source>Contact solve</source>
        <translation>Resolución del contacto</translation>
    </message>
    <message>
        <source>Friction solve</source>
        <translation>Resolución del rozamiento</translation>
    </message>
    <message>
        <source>Bursa films</source>
        <translation>Películas de bolsa</translation>
    </message>
    <message>
        <source>Dents under tools</source>
        <translation>Huellas bajo las herramientas</translation>
    </message>
    <message>
        <source>Moving on</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Switch on: %1</source>
        <translation>Activar: %1</translation>
    </message>
    <message>
        <source>Switch off: %1</source>
        <translation>Desactivar: %1</translation>
    </message>
    <message>
        <source>Let the scene decide: %1</source>
        <translation>Que decida la escena: %1</translation>
    </message>
    <message>
        <source>off: nothing</source>
        <translation>desactivado: nada</translation>
    </message>
    <message>
        <source>within “%1”</source>
        <translation>dentro de «%1»</translation>
    </message>
    <message>
        <source>%1, at most %2 in 95 of 100 steps</source>
        <translation>%1, como mucho %2 en 95 de cada 100 pasos</translation>
    </message>
</context>
<context>
    <name>glenoid::EffectSentences</name>
    <message>
        <source>one material</source>
        <translation>un material</translation>
    </message>
    <message>
        <source>%1 materials</source>
        <translation>%1 materiales</translation>
    </message>
    <message>
        <source>one tool</source>
        <translation>una herramienta</translation>
    </message>
    <message>
        <source>%1 tools</source>
        <translation>%1 herramientas</translation>
    </message>
    <message>
        <source>one part</source>
        <translation>una parte</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 partes</translation>
    </message>
    <message>
        <source>one coupling</source>
        <translation>un acoplamiento</translation>
    </message>
    <message>
        <source>%1 couplings</source>
        <translation>%1 acoplamientos</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>two things counted</comment>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 can move and gravity is %2 m/s²</source>
        <translation>hay libertad de movimiento en %1 y la gravedad es de %2 m/s²</translation>
    </message>
    <message>
        <source>the joint has %1, made of springs: %2</source>
        <translation>la articulación tiene %1, hechos de muelles: %2</translation>
    </message>
    <message>
        <source>one pair of parts or tools can touch</source>
        <translation>una pareja de partes o herramientas puede tocarse</translation>
    </message>
    <message>
        <source>%1 pairs of parts and tools can touch</source>
        <translation>%1 parejas de partes y herramientas pueden tocarse</translation>
    </message>
    <message>
        <source>the joint has a bursa</source>
        <translation>la articulación tiene una bolsa</translation>
    </message>
    <message>
        <source>a friction coefficient is given to %1</source>
        <translation>hay un coeficiente de rozamiento en %1</translation>
    </message>
    <message>
        <source>damping is given to %1</source>
        <translation>hay amortiguamiento en %1</translation>
    </message>
    <message>
        <source>the joint has %1 bursae</source>
        <translation>la articulación tiene %1 bolsas</translation>
    </message>
    <message>
        <source>a hand holds %1</source>
        <translation>una mano sostiene %1</translation>
    </message>
    <message>
        <source>the scene holds something it acts on</source>
        <translation>la escena contiene algo sobre lo que actúa</translation>
    </message>
    <message>
        <source>no part can move</source>
        <translation>ninguna parte puede moverse</translation>
    </message>
    <message>
        <source>the scenario’s gravity is zero</source>
        <translation>la gravedad del escenario es cero</translation>
    </message>
    <message>
        <source>the joint has no coupling</source>
        <translation>la articulación no tiene acoplamientos</translation>
    </message>
    <message>
        <source>no two parts or tools can touch</source>
        <translation>no hay partes ni herramientas que puedan tocarse</translation>
    </message>
    <message>
        <source>no soft part can move</source>
        <translation>ninguna parte blanda puede moverse</translation>
    </message>
    <message>
        <source>the scenario names no part that may fold onto itself</source>
        <translation>el escenario no nombra ninguna parte que pueda plegarse sobre sí misma</translation>
    </message>
    <message>
        <source>no material and no tool has a friction coefficient</source>
        <translation>ningún material ni herramienta tiene coeficiente de rozamiento</translation>
    </message>
    <message>
        <source>of no two surfaces that can touch have both a friction coefficient</source>
        <translation>no hay dos superficies que puedan tocarse y tengan ambas coeficiente de rozamiento</translation>
    </message>
    <message>
        <source>no material and no coupling damps</source>
        <translation>ningún material ni acoplamiento amortigua</translation>
    </message>
    <message>
        <source>the joint has no bursa</source>
        <translation>la articulación no tiene bolsas</translation>
    </message>
    <message>
        <source>the joint’s bursae cover no surface</source>
        <translation>las bolsas de la articulación no cubren ninguna superficie</translation>
    </message>
    <message>
        <source>for no part it is known how tissue gives under a tip</source>
        <translation>de ninguna parte se sabe cómo cede el tejido bajo una punta</translation>
    </message>
    <message>
        <source>no tool has a round tip</source>
        <translation>ninguna herramienta tiene punta redonda</translation>
    </message>
    <message>
        <source>parts were changed after it had been found out how they give under a tip</source>
        <translation>las partes cambiaron después de averiguar cómo ceden bajo una punta</translation>
    </message>
    <message>
        <source>nothing in the scene for it to act on</source>
        <translation>nada en la escena sobre lo que pueda actuar</translation>
    </message>
    <message>
        <source>off, because the scenario switches it off</source>
        <translation>desactivado, porque el escenario lo desactiva</translation>
    </message>
    <message>
        <source>off, because contact is off</source>
        <translation>desactivado, porque el contacto está desactivado</translation>
    </message>
    <message>
        <source>off, because this version does not have it</source>
        <translation>desactivado, porque esta versión no lo tiene</translation>
    </message>
    <message>
        <source>off, because it is no part of a step: “run --realtime” and a device switch it on</source>
        <translation>desactivado, porque no forma parte de un paso: lo activan «run --realtime» y un dispositivo</translation>
    </message>
    <message>
        <source>off, because %1</source>
        <translation>desactivado, porque %1</translation>
    </message>
    <message>
        <source>on, because the scenario asks for it and %1</source>
        <translation>activado, porque el escenario lo pide y %1</translation>
    </message>
    <message>
        <source>on, because %1</source>
        <translation>activado, porque %1</translation>
    </message>
    <message>
        <source>contact with itself is wanted for %1</source>
        <translation>se pide el contacto consigo misma de %1</translation>
    </message>
    <message>
        <source>for %1 it is known how tissue gives under a tip, and there is a round tip on %2</source>
        <translation>de %1 se sabe cómo cede el tejido bajo una punta, y hay punta redonda en %2</translation>
    </message>
</context>
<context>
    <name>glenoid::EffectsPanel</name>
    <message>
        <source>by the scene</source>
        <translation>según la escena</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>No scene runs.</source>
        <translation>No hay ninguna escena en marcha.</translation>
    </message>
    <message>
        <source>A step takes %1, and %2 at most in 95 of 100; it simulates %3.</source>
        <translation>Un paso tarda %1, y como mucho %2 en 95 de cada 100; simula %3.</translation>
    </message>
    <message>
        <source>Press play to see what each stage and effect takes.</source>
        <translation>Pulse reproducir para ver cuánto tarda cada etapa y cada efecto.</translation>
    </message>
    <message>
        <source>on: %1</source>
        <translation>activado: %1</translation>
    </message>
    <message>
        <source>off: %1</source>
        <translation>desactivado: %1</translation>
    </message>
    <message>
        <source>off: nothing (%1 when it was on)</source>
        <translation>desactivado: nada (%1 cuando estaba activado)</translation>
    </message>
    <message>
        <source>Whether this effect is on: %1</source>
        <translation>Si este efecto está activado: %1</translation>
    </message>
    <message>
        <source>%1 velocities, %2 rows</source>
        <translation>%1 velocidades, %2 filas</translation>
    </message>
    <message>
        <source>%1 velocities</source>
        <translation>%1 velocidades</translation>
    </message>
    <message>
        <source>Effects: what is on, why, and what it costs</source>
        <translation>Efectos: qué está activado, por qué y cuánto cuesta</translation>
    </message>
    <message>
        <source>Islands of the last step: what is solved as one, and what joins it</source>
        <translation>Islas del último paso: qué se resuelve junto y qué lo une</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>Switch</source>
        <translation>Interruptor</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Price of a step</source>
        <translation>Precio por paso</translation>
    </message>
    <message>
        <source>Effects with their price</source>
        <translation>Efectos con su precio</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Piezas</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Residuo</translation>
    </message>
    <message>
        <source>Why joined</source>
        <translation>Por qué están unidas</translation>
    </message>
    <message>
        <source>Solved by</source>
        <translation>Resuelta por</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Islas</translation>
    </message>
</context>
<context>
    <name>glenoid::ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>The cells of the simulation stand out of the part and are several times its volume. For another solver, write tetrahedra of the part itself.</source>
        <translation>Las celdas de la simulación sobresalen de la parte y son varias veces su volumen. Para otro programa de cálculo, escriba tetraedros de la propia parte.</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tetraedros</translation>
    </message>
    <message>
        <source>Of the simulation&apos;s cells</source>
        <translation>De las celdas de la simulación</translation>
    </message>
    <message>
        <source>Of the part itself</source>
        <translation>De la propia parte</translation>
    </message>
    <message>
        <source>Length of their edges</source>
        <translation>Longitud de sus aristas</translation>
    </message>
    <message>
        <source>Largest distance from the surface</source>
        <translation>Mayor distancia a la superficie</translation>
    </message>
    <message>
        <source>two thirds of the part&apos;s thickness</source>
        <translation>dos tercios del grosor de la parte</translation>
    </message>
    <message>
        <source>a tenth of the edges</source>
        <translation>un décimo de las aristas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>glenoid::ExportSentences</name>
    <message>
        <source>Rigid parts are left out: %1.</source>
        <translation>Se omiten partes rígidas: %1.</translation>
    </message>
    <message>
        <source>Surfaces are left out: %1.</source>
        <translation>Se omiten superficies: %1.</translation>
    </message>
    <message>
        <source>Volumes are left out: %1.</source>
        <translation>Se omiten volúmenes: %1.</translation>
    </message>
    <message>
        <source>Mechanical values of materials are left out: %1.</source>
        <translation>Se omiten valores mecánicos de materiales: %1.</translation>
    </message>
    <message>
        <source>The tissue law becomes neo-Hookean, with the same Young&apos;s modulus and Poisson&apos;s ratio.</source>
        <translation>La ley del tejido pasa a ser neohookeana, con el mismo módulo de Young y el mismo coeficiente de Poisson.</translation>
    </message>
    <message>
        <source>Tetrahedra that are only partly tissue are written as full ones, so they are stiffer and heavier: %1.</source>
        <translation>Los tetraedros que solo en parte son tejido se escriben como llenos, de modo que son más rígidos y pesados: %1.</translation>
    </message>
    <message>
        <source>Parts of several materials get their first one throughout: %1.</source>
        <translation>Las partes de varios materiales reciben en todas partes el primero: %1.</translation>
    </message>
    <message>
        <source>Couplings are left out: %1.</source>
        <translation>Se omiten acoplamientos: %1.</translation>
    </message>
    <message>
        <source>Couplings become bonds that do not give: %1.</source>
        <translation>Los acoplamientos pasan a ser uniones que no ceden: %1.</translation>
    </message>
    <message>
        <source>Nodes that two couplings hold get only one of the two bonds; bonds left out: %1.</source>
        <translation>Los nodos que sujetan dos acoplamientos reciben solo una de las dos uniones; uniones omitidas: %1.</translation>
    </message>
    <message>
        <source>Contact between the parts is left out.</source>
        <translation>Se omite el contacto entre las partes.</translation>
    </message>
    <message>
        <source>Contact becomes a penalty force instead of a hard limit.</source>
        <translation>El contacto pasa a ser una fuerza de penalización en lugar de un límite firme.</translation>
    </message>
    <message>
        <source>Friction is left out.</source>
        <translation>Se omite el rozamiento.</translation>
    </message>
    <message>
        <source>The damping of all materials becomes their mean.</source>
        <translation>El amortiguamiento de todos los materiales pasa a ser su media.</translation>
    </message>
    <message>
        <source>Which pairs of parts do not touch is left out: %1.</source>
        <translation>Se omite qué pares de partes no se tocan: %1.</translation>
    </message>
    <message>
        <source>Bursae are left out: %1.</source>
        <translation>Se omiten bolsas: %1.</translation>
    </message>
    <message>
        <source>Regions and landmarks are left out: %1.</source>
        <translation>Se omiten regiones y puntos de referencia: %1.</translation>
    </message>
    <message>
        <source>Cages are left out: %1.</source>
        <translation>Se omiten jaulas: %1.</translation>
    </message>
    <message>
        <source>Rigid parts are written as fixed, since who moves is a matter of the scenario: %1.</source>
        <translation>Las partes rígidas se escriben como fijas, ya que quién se mueve es asunto del escenario: %1.</translation>
    </message>
    <message>
        <source>Coordinates are rounded to single precision.</source>
        <translation>Las coordenadas se redondean a precisión simple.</translation>
    </message>
    <message>
        <source>Gmsh mesh of the volumes</source>
        <translation>Malla Gmsh de los volúmenes</translation>
    </message>
    <message>
        <source>VTK grid of the volumes</source>
        <translation>Malla VTK de los volúmenes</translation>
    </message>
    <message>
        <source>SOFA scene</source>
        <translation>Escena de SOFA</translation>
    </message>
    <message>
        <source>FEBio model</source>
        <translation>Modelo de FEBio</translation>
    </message>
    <message>
        <source>%1: %2 tetrahedra of its cells hold %3 cm³, %4 times the %5 cm³ of the part.</source>
        <translation>%1: %2 tetraedros de sus celdas contienen %3 cm³, %4 veces los %5 cm³ de la parte.</translation>
    </message>
    <message>
        <source>%1: %2 tetrahedra of the part itself hold %3 cm³ of its %4 cm³; least angle between faces %5°, least radius ratio %6.</source>
        <translation>%1: %2 tetraedros de la propia parte contienen %3 cm³ de sus %4 cm³; menor ángulo entre caras %5°, menor razón de radios %6.</translation>
    </message>
    <message>
        <source>CalculiX input</source>
        <translation>Entrada de CalculiX</translation>
    </message>
    <message>
        <source>glTF surfaces</source>
        <translation>Superficies glTF</translation>
    </message>
</context>
<context>
    <name>glenoid::FieldPanel</name>
    <message>
        <source>&amp;Colours by</source>
        <translation>&amp;Colorear según</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>No</translation>
    </message>
    <message>
        <source>What colours the parts</source>
        <translation>Qué colorea las partes</translation>
    </message>
    <message>
        <source>Colour the parts by what they bear; point at one to read its value</source>
        <translation>Colorea las partes según lo que soportan; señale una para leer su valor</translation>
    </message>
    <message>
        <source>Automatic scale</source>
        <translation>Escala automática</translation>
    </message>
    <message>
        <source>The scale follows the values, in round steps; without it, it stays as it is</source>
        <translation>La escala sigue los valores, en pasos redondos; si no, se queda como está</translation>
    </message>
    <message>
        <source>Low end of the scale</source>
        <translation>Extremo inferior de la escala</translation>
    </message>
    <message>
        <source>High end of the scale</source>
        <translation>Extremo superior de la escala</translation>
    </message>
</context>
<context>
    <name>glenoid::FieldText</name>
    <message>
        <source>Stress</source>
        <translation>Tensión</translation>
    </message>
    <message>
        <source>Strain</source>
        <translation>Deformación</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>Presión</translation>
    </message>
    <message>
        <source>Contact force</source>
        <translation>Fuerza de contacto</translation>
    </message>
    <message>
        <source>Von Mises stress</source>
        <translation>Tensión de von Mises</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>Deformación máxima</translation>
    </message>
    <message>
        <source>Pressure in tissue</source>
        <translation>Presión en el tejido</translation>
    </message>
    <message>
        <source>Contact force per area</source>
        <translation>Fuerza de contacto por área</translation>
    </message>
    <message>
        <source>%1: %2 von Mises stress</source>
        <translation>%1: %2 de tensión de von Mises</translation>
    </message>
    <message>
        <source>%1: %2 largest strain</source>
        <translation>%1: %2 de deformación máxima</translation>
    </message>
    <message>
        <source>%1: %2 pressure in tissue</source>
        <translation>%1: %2 de presión en el tejido</translation>
    </message>
    <message>
        <source>%1: %2 contact force per area</source>
        <translation>%1: %2 de fuerza de contacto por área</translation>
    </message>
    <message>
        <source>%1: contact force is not read on tools</source>
        <translation>%1: la fuerza de contacto no se lee en las herramientas</translation>
    </message>
    <message>
        <source>%1: rigid, so nothing to read inside</source>
        <translation>%1: rígida, así que no hay nada que leer dentro</translation>
    </message>
</context>
<context>
    <name>glenoid::HistoryPanel</name>
    <message>
        <source>History of changes</source>
        <translation>Historial de cambios</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Como se abrió</translation>
    </message>
</context>
<context>
    <name>glenoid::ImportDialog</name>
    <message>
        <source>Import surfaces</source>
        <translation>Importar superficies</translation>
    </message>
    <message>
        <source>Stop &amp;reading</source>
        <translation>Dejar de &amp;leer</translation>
    </message>
    <message>
        <source>&amp;Import</source>
        <translation>&amp;Importar</translation>
    </message>
    <message>
        <source>Surfaces that arrived</source>
        <translation>Superficies recibidas</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Picture of the surface</source>
        <translation>Imagen de la superficie</translation>
    </message>
    <message>
        <source>Show what it &amp;becomes</source>
        <translation>Mostrar el &amp;resultado</translation>
    </message>
    <message>
        <source>What was found, and repairs</source>
        <translation>Lo encontrado y sus reparaciones</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparación</translation>
    </message>
    <message>
        <source>&amp;Unit of the file</source>
        <translation>&amp;Unidad del archivo</translation>
    </message>
    <message>
        <source>As here: X forward, Y up, Z to the right</source>
        <translation>Como aquí: X adelante, Y arriba, Z a la derecha</translation>
    </message>
    <message>
        <source>Atlas or scanner (LPS): Z up, Y backward, right is −X</source>
        <translation>Atlas o escáner (LPS): Z arriba, Y atrás, la derecha es −X</translation>
    </message>
    <message>
        <source>Scanner (RAS): Z up, Y forward, right is +X</source>
        <translation>Escáner (RAS): Z arriba, Y adelante, la derecha es +X</translation>
    </message>
    <message>
        <source>Figures that face +Z: Y up, right is −X</source>
        <translation>Figuras que miran a +Z: Y arriba, la derecha es −X</translation>
    </message>
    <message>
        <source>Z up, X forward, right is −Y</source>
        <translation>Z arriba, X adelante, la derecha es −Y</translation>
    </message>
    <message>
        <source>A&amp;xes of the file</source>
        <translation>E&amp;jes del archivo</translation>
    </message>
    <message>
        <source>It is of a &amp;left side: mirror it</source>
        <translation>Es del lado &amp;izquierdo: reflejarla</translation>
    </message>
    <message>
        <source>Size that results</source>
        <translation>Tamaño resultante</translation>
    </message>
    <message>
        <source>Unit and axes for &amp;all</source>
        <translation>Unidad y ejes para &amp;todas</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Thin is less than</source>
        <translation>&amp;Delgado es menos de</translation>
    </message>
    <message>
        <source>Shift forward</source>
        <translation>Desplazamiento hacia delante</translation>
    </message>
    <message>
        <source>Shift up</source>
        <translation>Desplazamiento hacia arriba</translation>
    </message>
    <message>
        <source>Shift to the side</source>
        <translation>Desplazamiento hacia el lado</translation>
    </message>
    <message>
        <source>&amp;Centre</source>
        <translation>&amp;Centrar</translation>
    </message>
    <message>
        <source>Shift of all</source>
        <translation>Desplazamiento de todas</translation>
    </message>
    <message>
        <source>Nothing is wrong with it.</source>
        <translation>No tiene ningún defecto.</translation>
    </message>
    <message>
        <source>Files are being read and judged…</source>
        <translation>Se están leyendo y examinando los archivos…</translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) will be added as rigid parts.</source>
        <translation>
            <numerusform>Se añadirá %n superficie como pieza rígida.</numerusform>
            <numerusform>Se añadirán %n superficies como piezas rígidas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n could not be read.</source>
        <translation>
            <numerusform>%n no se ha podido leer.</numerusform>
            <numerusform>%n no se han podido leer.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of them are not sound: the joint will not run before that is mended.</source>
        <translation>
            <numerusform>%n de ellas no es correcta: la articulación no funcionará hasta que se repare.</numerusform>
            <numerusform>%n de ellas no son correctas: la articulación no funcionará hasta que se reparen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ImportSession</name>
    <message numerus="yes">
        <source>Import %n surface(s)</source>
        <translation>
            <numerusform>Importar %n superficie</numerusform>
            <numerusform>Importar %n superficies</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::ImportWords</name>
    <message>
        <source>The file does not say its unit.</source>
        <translation>El archivo no dice su unidad.</translation>
    </message>
    <message>
        <source>The unit is not clear: look at the size.</source>
        <translation>La unidad no está clara: compruebe el tamaño.</translation>
    </message>
    <message>
        <source>Both sides of a body are in one surface.</source>
        <translation>Los dos lados de un cuerpo están en una sola superficie.</translation>
    </message>
    <message numerus="yes">
        <source>It consists of %n piece(s).</source>
        <translation>
            <numerusform>Consta de %n trozo.</numerusform>
            <numerusform>Consta de %n trozos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) belong to no triangle.</source>
        <translation>
            <numerusform>%n punto no pertenece a ningún triángulo.</numerusform>
            <numerusform>%n puntos no pertenecen a ningún triángulo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) lie on others.</source>
        <translation>
            <numerusform>%n punto coincide con otro.</numerusform>
            <numerusform>%n puntos coinciden con otros.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) have no area.</source>
        <translation>
            <numerusform>%n triángulo no tiene área.</numerusform>
            <numerusform>%n triángulos no tienen área.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle(s) are there twice.</source>
        <translation>
            <numerusform>%n triángulo está repetido.</numerusform>
            <numerusform>%n triángulos están repetidos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n edge(s) have three or more triangles.</source>
        <translation>
            <numerusform>%n arista tiene tres o más triángulos.</numerusform>
            <numerusform>%n aristas tienen tres o más triángulos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n point(s) pinch the surface.</source>
        <translation>
            <numerusform>%n punto estrangula la superficie.</numerusform>
            <numerusform>%n puntos estrangulan la superficie.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>At %n edge(s) the triangles face contrary ways.</source>
        <translation>
            <numerusform>En %n arista los triángulos miran a lados contrarios.</numerusform>
            <numerusform>En %n aristas los triángulos miran a lados contrarios.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) are inside out.</source>
        <translation>
            <numerusform>%n trozo está del revés.</numerusform>
            <numerusform>%n trozos están del revés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s); the longest is %1 mm around.</source>
        <translation>
            <numerusform>%n agujero; su contorno mide %1 mm.</numerusform>
            <numerusform>%n agujeros; el mayor contorno mide %1 mm.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) have no thickness.</source>
        <translation>
            <numerusform>%n trozo no tiene espesor.</numerusform>
            <numerusform>%n trozos no tienen espesor.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The surface has %n handle(s), as a ring has one.</source>
        <translation>
            <numerusform>La superficie tiene %n asa, como la de un anillo.</numerusform>
            <numerusform>La superficie tiene %n asas, como la única de un anillo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pair(s) of triangles cut each other.</source>
        <translation>
            <numerusform>%n par de triángulos se corta.</numerusform>
            <numerusform>%n pares de triángulos se cortan.</numerusform>
        </translation>
    </message>
    <message>
        <source>Walls are thin in places; %1 mm is their middle.</source>
        <translation>Las paredes son delgadas en algunos sitios; la mediana es %1 mm.</translation>
    </message>
    <message>
        <source>Walls are thin: %1 mm in the middle.</source>
        <translation>Las paredes son delgadas: la mediana es %1 mm.</translation>
    </message>
    <message>
        <source>The surface holds indices or numbers that make no sense.</source>
        <translation>La superficie contiene índices o números sin sentido.</translation>
    </message>
    <message>
        <source>Keep the side with the lower coordinates</source>
        <translation>Conservar el lado de coordenadas menores</translation>
    </message>
    <message>
        <source>Drop the small pieces</source>
        <translation>Quitar los trozos pequeños</translation>
    </message>
    <message>
        <source>Keep the largest piece alone</source>
        <translation>Conservar solo el trozo mayor</translation>
    </message>
    <message>
        <source>Drop them</source>
        <translation>Quitarlos</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>Unirlos</translation>
    </message>
    <message>
        <source>Remove them without opening cracks</source>
        <translation>Quitarlos sin abrir grietas</translation>
    </message>
    <message>
        <source>Keep one of each</source>
        <translation>Conservar uno de cada</translation>
    </message>
    <message>
        <source>Cut the surface apart there, drop the scraps and close what is left open</source>
        <translation>Separar ahí la superficie, quitar los restos y cerrar lo que quede abierto</translation>
    </message>
    <message>
        <source>Cut the surface apart there</source>
        <translation>Separar ahí la superficie</translation>
    </message>
    <message>
        <source>Turn triangles so that neighbours face alike</source>
        <translation>Girar triángulos para que los vecinos miren igual</translation>
    </message>
    <message>
        <source>Turn them outwards</source>
        <translation>Girarlos hacia fuera</translation>
    </message>
    <message>
        <source>Close them</source>
        <translation>Cerrarlos</translation>
    </message>
    <message>
        <source>Thicken to %1 mm</source>
        <translation>Engrosar hasta %1 mm</translation>
    </message>
    <message>
        <source>Draw a new closed surface around it</source>
        <translation>Envolverla en una superficie cerrada nueva</translation>
    </message>
    <message>
        <source>Cut those triangles out and close the holes</source>
        <translation>Recortar esos triángulos y cerrar los agujeros</translation>
    </message>
    <message numerus="yes">
        <source>%n polygon(s) were cut into triangles.</source>
        <translation>
            <numerusform>%n polígono se ha dividido en triángulos.</numerusform>
            <numerusform>%n polígonos se han dividido en triángulos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n triangle strip(s) were cut into triangles.</source>
        <translation>
            <numerusform>%n tira se ha dividido en triángulos.</numerusform>
            <numerusform>%n tiras se han dividido en triángulos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeated point(s) were joined.</source>
        <translation>
            <numerusform>%n punto repetido se ha unido.</numerusform>
            <numerusform>%n puntos repetidos se han unido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) had a transform, which was applied.</source>
        <translation>
            <numerusform>%n nodo tenía una transformación, que se ha aplicado.</numerusform>
            <numerusform>%n nodos tenían transformaciones, que se han aplicado.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n node(s) were mirrored; their triangles were turned back.</source>
        <translation>
            <numerusform>%n nodo estaba reflejado; sus triángulos se han girado.</numerusform>
            <numerusform>%n nodos estaban reflejados; sus triángulos se han girado.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) were left out.</source>
        <translation>
            <numerusform>%n línea se ha omitido.</numerusform>
            <numerusform>%n líneas se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n single point(s) were left out.</source>
        <translation>
            <numerusform>%n punto suelto se ha omitido.</numerusform>
            <numerusform>%n puntos sueltos se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Normals of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Se han omitido las normales de %n superficie.</numerusform>
            <numerusform>Se han omitido las normales de %n superficies.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Texture coordinates of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Se han omitido las coordenadas de textura de %n superficie.</numerusform>
            <numerusform>Se han omitido las coordenadas de textura de %n superficies.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %n surface(s) were left out.</source>
        <translation>
            <numerusform>Se han omitido los colores de %n superficie.</numerusform>
            <numerusform>Se han omitido los colores de %n superficies.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n material(s) were left out.</source>
        <translation>
            <numerusform>%n material se ha omitido.</numerusform>
            <numerusform>%n materiales se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n animation(s) or bone(s) were left out.</source>
        <translation>
            <numerusform>%n animación o hueso de esqueleto se ha omitido.</numerusform>
            <numerusform>%n animaciones o huesos de esqueleto se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n light(s) or camera(s) were left out.</source>
        <translation>
            <numerusform>%n luz o cámara se ha omitido.</numerusform>
            <numerusform>%n luces o cámaras se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n array(s) of values were left out.</source>
        <translation>
            <numerusform>%n lista de valores se ha omitido.</numerusform>
            <numerusform>%n listas de valores se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n surface(s) without triangles were left out.</source>
        <translation>
            <numerusform>%n superficie sin triángulos se ha omitido.</numerusform>
            <numerusform>%n superficies sin triángulos se han omitido.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Of %n solid cell(s) the outside was taken.</source>
        <translation>
            <numerusform>De %n celda sólida se ha tomado el exterior.</numerusform>
            <numerusform>De %n celdas sólidas se ha tomado el exterior.</numerusform>
        </translation>
    </message>
    <message>
        <source>The file says so.</source>
        <translation>Lo dice el archivo.</translation>
    </message>
    <message>
        <source>Guessed from the size of such a part (%1 %).</source>
        <translation>Supuesta por el tamaño de una pieza así (%1 %).</translation>
    </message>
    <message>
        <source>Guessed from the place in a body (%1 %).</source>
        <translation>Supuesta por el lugar en el cuerpo (%1 %).</translation>
    </message>
    <message>
        <source>Guessed from the size (%1 %).</source>
        <translation>Supuesta por el tamaño (%1 %).</translation>
    </message>
    <message>
        <source>No unit fits well: choose one.</source>
        <translation>Ninguna unidad encaja bien: elija una.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milímetros</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centímetros</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metros</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>micrómetros</translation>
    </message>
    <message>
        <source>units of %1 m</source>
        <translation>unidades de %1 m</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
    <message>
        <source>both</source>
        <translation>ambos</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Being read…</source>
        <translation>Leyéndose…</translation>
    </message>
    <message>
        <source>Being worked on…</source>
        <translation>Procesándose…</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Ha fallado</translation>
    </message>
    <message>
        <source>Not closed or not sound yet</source>
        <translation>Aún no está cerrada o correcta</translation>
    </message>
    <message>
        <source>Sound, but cuts itself</source>
        <translation>Correcta, pero se corta a sí misma</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Correcta</translation>
    </message>
</context>
<context>
    <name>glenoid::IslandRows</name>
    <message>
        <source>nothing presses</source>
        <translation>nada aprieta</translation>
    </message>
    <message>
        <source>pivoting</source>
        <translation>pivotes</translation>
    </message>
    <message>
        <source>Newton on impulses</source>
        <translation>Newton en impulsos</translation>
    </message>
    <message>
        <source>Newton on velocities</source>
        <translation>Newton en velocidades</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>como se publicó</translation>
    </message>
    <message>
        <source>%1 coupled to %2</source>
        <translation>%1 acoplada a %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 touches %2: %n contact(s), %3 N</source>
        <translation>
            <numerusform>%1 toca %2: %n contacto, %3 N</numerusform>
            <numerusform>%1 toca %2: %n contactos, %3 N</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 touches itself: %n contact(s), %2 N</source>
        <translation>
            <numerusform>%1 se toca a sí misma: %n contacto, %2 N</numerusform>
            <numerusform>%1 se toca a sí misma: %n contactos, %2 N</numerusform>
        </translation>
    </message>
    <message>
        <source>by itself: nothing touches it and nothing free is coupled to it</source>
        <translation>sola: nada la toca y nada libre está acoplado a ella</translation>
    </message>
    <message>
        <source>free motion</source>
        <translation>movimiento libre</translation>
    </message>
</context>
<context>
    <name>glenoid::JobSystem</name>
    <message>
        <source>“%1” was dropped: the scene was changed in what it works on. Start it again.</source>
        <translation>Se ha descartado «%1»: la escena cambió en aquello con lo que trabaja. Inícielo de nuevo.</translation>
    </message>
</context>
<context>
    <name>glenoid::JobsBar</name>
    <message>
        <source>Stop this work; nothing will be changed</source>
        <translation>Detener este trabajo; no se cambiará nada</translation>
    </message>
    <message>
        <source>Stop this work</source>
        <translation>Detener este trabajo</translation>
    </message>
    <message>
        <source>How far the work is</source>
        <translation>Avance del trabajo</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Deteniendo…</translation>
    </message>
    <message numerus="yes">
        <source>%1 (about %n minute(s) left)</source>
        <translation>
            <numerusform>%1 (queda cerca de %n minuto)</numerusform>
            <numerusform>%1 (quedan cerca de %n minutos)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (about %n second(s) left)</source>
        <translation>
            <numerusform>%1 (queda cerca de %n segundo)</numerusform>
            <numerusform>%1 (quedan cerca de %n segundos)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 y %n más</numerusform>
            <numerusform>%1 y %n más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::JointEdits</name>
    <message>
        <source>Rename the joint to “%1”</source>
        <translation>Cambiar el nombre de la articulación a «%1»</translation>
    </message>
    <message>
        <source>Describe the joint</source>
        <translation>Describir la articulación</translation>
    </message>
    <message>
        <source>Change the licence of the joint</source>
        <translation>Cambiar la licencia de la articulación</translation>
    </message>
    <message>
        <source>Say who made the joint</source>
        <translation>Decir quién hizo la articulación</translation>
    </message>
    <message>
        <source>Make it a left joint</source>
        <translation>Hacerla una articulación izquierda</translation>
    </message>
    <message>
        <source>Make it a right joint</source>
        <translation>Hacerla una articulación derecha</translation>
    </message>
    <message>
        <source>Make it a joint of no side</source>
        <translation>Dejar la articulación sin lado</translation>
    </message>
    <message>
        <source>Mirror the joint</source>
        <translation>Reflejar la articulación</translation>
    </message>
</context>
<context>
    <name>glenoid::LabDocks</name>
    <message>
        <source>The report could not be written.</source>
        <translation>No se pudo escribir el informe.</translation>
    </message>
    <message>
        <source>&amp;Report of the studies…</source>
        <translation>&amp;Informe de los estudios…</translation>
    </message>
    <message>
        <source>Write the studies that the lab shows as one document, HTML or PDF</source>
        <translation>Escribir los estudios que muestra el laboratorio en un documento, HTML o PDF</translation>
    </message>
    <message>
        <source>There is no study to report on. Run one in the lab, or open one there.</source>
        <translation>No hay ningún estudio del que informar. Haga uno en el laboratorio o ábralo allí.</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>Página web (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Escribir el informe</translation>
    </message>
    <message>
        <source>A report is being written already.</source>
        <translation>Ya se está escribiendo un informe.</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Exactitud</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Estabilidad</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
</context>
<context>
    <name>glenoid::LayersPanel</name>
    <message>
        <source>Visual</source>
        <translation>Visual</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Colisión</translation>
    </message>
    <message>
        <source>Dynamics</source>
        <translation>Dinámica</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Regiones</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Orientación</translation>
    </message>
    <message>
        <source>Show the smooth visual surfaces</source>
        <translation>Mostrar las superficies visuales, suavizadas</translation>
    </message>
    <message>
        <source>Show the surfaces that collide, with their edges</source>
        <translation>Mostrar las superficies que colisionan, con sus aristas</translation>
    </message>
    <message>
        <source>Show the tetrahedra that deform</source>
        <translation>Mostrar los tetraedros que se deforman</translation>
    </message>
    <message>
        <source>Show the springs that couple the parts</source>
        <translation>Mostrar los muelles que acoplan las partes</translation>
    </message>
    <message>
        <source>Show where parts touch, and how hard</source>
        <translation>Mostrar dónde se tocan las partes y con qué fuerza</translation>
    </message>
    <message>
        <source>Show the named regions of the parts</source>
        <translation>Mostrar las regiones con nombre de las partes</translation>
    </message>
    <message>
        <source>Show which way is front, up and outward</source>
        <translation>Mostrar hacia dónde están delante, arriba y afuera</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Rótulos</translation>
    </message>
    <message>
        <source>Show the names of what is seen</source>
        <translation>Mostrar los nombres de lo que se ve</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Islas</translation>
    </message>
    <message>
        <source>Colour the parts by what couplings join; fixed parts keep their colour</source>
        <translation>Colorear las piezas según lo que unen los acoplamientos; las piezas fijas conservan su color</translation>
    </message>
</context>
<context>
    <name>glenoid::LoadEdits</name>
    <message>
        <source>Change the time in which loads rise</source>
        <translation>Cambiar el tiempo en que crecen las cargas</translation>
    </message>
    <message>
        <source>Change a load on “%1”</source>
        <translation>Cambiar una carga sobre «%1»</translation>
    </message>
    <message>
        <source>Add a load on “%1”</source>
        <translation>Añadir una carga sobre «%1»</translation>
    </message>
    <message>
        <source>Remove a load from “%1”</source>
        <translation>Quitar una carga de «%1»</translation>
    </message>
</context>
<context>
    <name>glenoid::LoadFields</name>
    <message>
        <source>Loads</source>
        <translation>Cargas</translation>
    </message>
    <message>
        <source>Add a load</source>
        <translation>Añadir una carga</translation>
    </message>
    <message>
        <source>Time in which loads rise</source>
        <translation>Tiempo en que crecen las cargas</translation>
    </message>
    <message>
        <source>Loads rise evenly from nothing over this time from the start; 0: they are whole at once</source>
        <translation>Las cargas crecen por igual desde cero durante este tiempo desde el comienzo; 0: están completas enseguida</translation>
    </message>
    <message>
        <source>They rise over (s):</source>
        <translation>Crecen durante (s):</translation>
    </message>
    <message>
        <source>%1. On “%2”</source>
        <translation>%1. Sobre «%2»</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove load %1</source>
        <translation>Quitar la carga %1</translation>
    </message>
    <message>
        <source>Force (N):</source>
        <translation>Fuerza (N):</translation>
    </message>
    <message>
        <source>Torque (N·m):</source>
        <translation>Par (N·m):</translation>
    </message>
    <message>
        <source>Point (mm):</source>
        <translation>Punto (mm):</translation>
    </message>
    <message>
        <source>at the origin, as the part carries it</source>
        <translation>en el origen, tal como lo lleva la pieza</translation>
    </message>
    <message>
        <source>spread over the part as its weight is</source>
        <translation>repartida sobre la pieza como su peso</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Dónde:</translation>
    </message>
    <message>
        <source>Force of load %1 along %2</source>
        <translation>Fuerza de la carga %1 según %2</translation>
    </message>
    <message>
        <source>Torque of load %1 about %2</source>
        <translation>Par de la carga %1 alrededor de %2</translation>
    </message>
    <message>
        <source>Point of load %1 along %2</source>
        <translation>Punto de la carga %1 según %2</translation>
    </message>
</context>
<context>
    <name>glenoid::MainWindow</name>
    <message>
        <source>Empty the field</source>
        <translation>Vaciar el campo</translation>
    </message>
    <message>
        <source>Select the whole table</source>
        <translation>Seleccionar toda la tabla</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation>&amp;Simular</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Partes</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>Propiedades</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Open a &amp;built-in scene</source>
        <translation>A&amp;brir una escena incluida</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>S&amp;olver</source>
        <translation>Mét&amp;odo</translation>
    </message>
    <message>
        <source>Look &amp;from</source>
        <translation>&amp;Mirar desde</translation>
    </message>
    <message>
        <source>File and view</source>
        <translation>Archivo y vista</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>3D view of the joint</source>
        <translation>Vista 3D de la articulación</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Cerrar el mensaje</translation>
    </message>
    <message>
        <source>Glenoid Studio</source>
        <translation>Glenoid Studio</translation>
    </message>
    <message>
        <source>%1[*] — Glenoid Studio</source>
        <translation>%1[*] — Glenoid Studio</translation>
    </message>
    <message>
        <source>Opening the scene…</source>
        <translation>Abriendo la escena…</translation>
    </message>
    <message>
        <source>Preparing the simulation…</source>
        <translation>Preparando la simulación…</translation>
    </message>
    <message>
        <source>No scene is open</source>
        <translation>No hay ninguna escena abierta</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) could not be taken; the last good state was kept</source>
        <translation>
            <numerusform>No se pudo dar %n paso; se conservó el último estado válido</numerusform>
            <numerusform>No se pudieron dar %n pasos; se conservó el último estado válido</numerusform>
        </translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>The scene has changes that are not saved. Save them before going on?</source>
        <translation>La escena tiene cambios sin guardar. ¿Quiere guardarlos antes de continuar?</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a &amp;joint…</source>
        <translation>Abrir una a&amp;rticulación…</translation>
    </message>
    <message>
        <source>Open a .joint folder</source>
        <translation>Abrir una carpeta .joint</translation>
    </message>
    <message>
        <source>&amp;Arthroscopy of the shoulder</source>
        <translation>&amp;Artroscopia del hombro</translation>
    </message>
    <message>
        <source>Arthroscopy with &amp;capsule and ligaments</source>
        <translation>Artroscopia con &amp;cápsula y ligamentos</translation>
    </message>
    <message>
        <source>&amp;Palpation of the shoulder</source>
        <translation>&amp;Palpación del hombro</translation>
    </message>
    <message>
        <source>The &amp;shoulder alone</source>
        <translation>El &amp;hombro solo</translation>
    </message>
    <message>
        <source>Open a scene that ships with the program</source>
        <translation>Abrir una escena incluida con el programa</translation>
    </message>
    <message>
        <source>Save joint and scenario under a name</source>
        <translation>Guardar la articulación y el escenario con un nombre</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>&amp;Exportar imagen…</translation>
    </message>
    <message>
        <source>Save what the view shows as a PNG file</source>
        <translation>Guardar lo que muestra la vista como archivo PNG</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Cerrar el programa</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>Take the last change back</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Volver a hacer el cambio</translation>
    </message>
    <message>
        <source>Select &amp;nothing</source>
        <translation>No seleccionar &amp;nada</translation>
    </message>
    <message>
        <source>Clear the selection</source>
        <translation>Quitar la selección</translation>
    </message>
    <message>
        <source>&amp;Frame selection</source>
        <translation>&amp;Encuadrar la selección</translation>
    </message>
    <message>
        <source>Bring the selected parts into view</source>
        <translation>Traer a la vista las partes seleccionadas</translation>
    </message>
    <message>
        <source>Frame &amp;all</source>
        <translation>Encuadrar &amp;todo</translation>
    </message>
    <message>
        <source>Bring everything into view</source>
        <translation>Traer todo a la vista</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>&amp;Inicio</translation>
    </message>
    <message>
        <source>Go back to the first view of the scene</source>
        <translation>Volver a la primera vista de la escena</translation>
    </message>
    <message>
        <source>A&amp;nterior (front)</source>
        <translation>A&amp;nterior (delante)</translation>
    </message>
    <message>
        <source>&amp;Posterior (back)</source>
        <translation>&amp;Posterior (detrás)</translation>
    </message>
    <message>
        <source>&amp;Lateral (outside)</source>
        <translation>&amp;Lateral (fuera)</translation>
    </message>
    <message>
        <source>&amp;Medial (inside)</source>
        <translation>&amp;Medial (dentro)</translation>
    </message>
    <message>
        <source>&amp;Superior (above)</source>
        <translation>&amp;Superior (arriba)</translation>
    </message>
    <message>
        <source>&amp;Inferior (below)</source>
        <translation>&amp;Inferior (abajo)</translation>
    </message>
    <message>
        <source>Look at the joint from this side</source>
        <translation>Mirar la articulación desde este lado</translation>
    </message>
    <message>
        <source>&amp;Dark theme</source>
        <translation>Tema &amp;oscuro</translation>
    </message>
    <message>
        <source>Switch between dark and light colours</source>
        <translation>Cambiar entre colores oscuros y claros</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pausar</translation>
    </message>
    <message>
        <source>Hold the simulation</source>
        <translation>Detener la simulación por un momento</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Iniciar</translation>
    </message>
    <message>
        <source>Run the simulation</source>
        <translation>Poner en marcha la simulación</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Paso</translation>
    </message>
    <message>
        <source>Take a single simulation step</source>
        <translation>Dar un solo paso de simulación</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Restablecer</translation>
    </message>
    <message>
        <source>Put everything back to the start</source>
        <translation>Devolver todo al principio</translation>
    </message>
    <message>
        <source>&amp;As published</source>
        <translation>&amp;Como se publicó</translation>
    </message>
    <message>
        <source>The method of the paper, step by step</source>
        <translation>El método del artículo, paso a paso</translation>
    </message>
    <message>
        <source>&amp;Reference</source>
        <translation>&amp;Referencia</translation>
    </message>
    <message>
        <source>Slow and exact; measures the error of the others</source>
        <translation>Lento y exacto; mide el error de los demás</translation>
    </message>
    <message>
        <source>&amp;Direct</source>
        <translation>&amp;Directo</translation>
    </message>
    <message>
        <source>Fast and exact; the one to work with</source>
        <translation>Rápido y exacto; el indicado para trabajar</translation>
    </message>
    <message>
        <source>&amp;About Glenoid Studio</source>
        <translation>&amp;Acerca de Glenoid Studio</translation>
    </message>
    <message>
        <source>What this program is, and is not</source>
        <translation>Qué es este programa y qué no es</translation>
    </message>
    <message>
        <source>Open a scenario</source>
        <translation>Abrir un escenario</translation>
    </message>
    <message>
        <source>Open a joint folder</source>
        <translation>Abrir una carpeta de articulación</translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation>Guardar la escena</translation>
    </message>
    <message>
        <source>Scenarios (*.scenario.json)</source>
        <translation>Escenarios (*.scenario.json)</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>Exportar una imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Imágenes (*.png)</translation>
    </message>
    <message>
        <source>About Glenoid Studio</source>
        <translation>Acerca de Glenoid Studio</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Glenoid Studio&lt;/h3&gt;&lt;p&gt;Author interactive simulations of human joints, and train on them.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Glenoid Studio&lt;/h3&gt;&lt;p&gt;Cree simulaciones interactivas de articulaciones humanas y entrene con ellas.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;This is a training aid, not a medical device. Do not use it for diagnosis, for treatment or to plan an operation.&lt;/p&gt;&lt;p&gt;The method follows Otaduy, Garre, Gascón, Miguel, Pérez and Zurdo, “Modeling and Simulation of a Human Shoulder for Interactive Medical Applications”, CEIG 2010.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Esto es una ayuda para el entrenamiento, no un producto sanitario. No lo use para diagnosticar, para tratar ni para planificar una operación.&lt;/p&gt;&lt;p&gt;El método sigue a Otaduy, Garre, Gascón, Miguel, Pérez y Zurdo, «Modeling and Simulation of a Human Shoulder for Interactive Medical Applications», CEIG 2010.&lt;/p&gt;&lt;p&gt;Software libre bajo la Licencia Pública General de GNU, versión 3 o posterior.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>&amp;Recover…</source>
        <translation>&amp;Recuperar…</translation>
    </message>
    <message>
        <source>Find unsaved work of a program that was closed or killed</source>
        <translation>Buscar trabajo sin guardar de un programa que se cerró o se interrumpió</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recuperar trabajo sin guardar</translation>
    </message>
    <message>
        <source>There is no unsaved work to recover.</source>
        <translation>No hay trabajo sin guardar que recuperar.</translation>
    </message>
    <message>
        <source>Export &amp;joint…</source>
        <translation>Exportar &amp;articulación…</translation>
    </message>
    <message>
        <source>Write the joint for Gmsh, VTK, SOFA, FEBio, CalculiX or glTF</source>
        <translation>Escribir la articulación para Gmsh, VTK, SOFA, FEBio, CalculiX o glTF</translation>
    </message>
    <message>
        <source>Export the joint</source>
        <translation>Exportar la articulación</translation>
    </message>
    <message>
        <source>Export %1</source>
        <translation>Exportar %1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>The joint was written to %1.</source>
        <translation>La articulación se ha escrito en %1.</translation>
    </message>
    <message>
        <source>&lt;p&gt;What the file does not hold:&lt;/p&gt;&lt;ul&gt;%1&lt;/ul&gt;</source>
        <translation>&lt;p&gt;Lo que el archivo no contiene:&lt;/p&gt;&lt;ul&gt;%1&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&amp;Import surfaces…</source>
        <translation>&amp;Importar superficies…</translation>
    </message>
    <message>
        <source>Bring in surface meshes of other programs</source>
        <translation>Traer mallas de superficie de otros programas</translation>
    </message>
    <message>
        <source>Import surfaces</source>
        <translation>Importar superficies</translation>
    </message>
    <message>
        <source>Surfaces (%1);;All files (*)</source>
        <translation>Superficies (%1);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>&amp;New joint</source>
        <translation>&amp;Nueva articulación</translation>
    </message>
    <message>
        <source>Begin a joint without parts; bring surfaces in then</source>
        <translation>Empezar una articulación sin partes; después, traer superficies</translation>
    </message>
    <message>
        <source>Untitled joint</source>
        <translation>Articulación sin título</translation>
    </message>
    <message>
        <source>&amp;Delete parts</source>
        <translation>&amp;Eliminar partes</translation>
    </message>
    <message>
        <source>Delete the selected parts with everything that refers to them</source>
        <translation>Eliminar las partes seleccionadas con todo lo que se refiere a ellas</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n part(s)</source>
        <translation>
            <numerusform>Eliminar %n parte</numerusform>
            <numerusform>Eliminar %n partes</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Colours by</source>
        <translation>&amp;Colorear según</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>No</translation>
    </message>
    <message>
        <source>Colour the parts by what they bear</source>
        <translation>Colorea las partes según lo que soportan</translation>
    </message>
    <message>
        <source>Show the parts as they look</source>
        <translation>Muestra las partes con su aspecto propio</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Siguiente</translation>
    </message>
    <message>
        <source>Colour by stress, strain, pressure, contact force, and off again</source>
        <translation>Colorea según tensión, deformación, presión, fuerza de contacto, y otra vez nada</translation>
    </message>
    <message>
        <source>New joint from a &amp;template</source>
        <translation>Articulación nueva a partir de una p&amp;lantilla</translation>
    </message>
    <message>
        <source>&amp;Elbow</source>
        <translation>&amp;Codo</translation>
    </message>
    <message>
        <source>&amp;Knee</source>
        <translation>&amp;Rodilla</translation>
    </message>
    <message>
        <source>Make a small joint with recipe, scenario and meshes, to be edited</source>
        <translation>Crear una articulación pequeña con receta, escenario y mallas, para modificarla</translation>
    </message>
    <message>
        <source>Make a folder for the new joint</source>
        <translation>Crear una carpeta para la articulación nueva</translation>
    </message>
    <message>
        <source>New joint in %1</source>
        <translation>Articulación nueva en %1</translation>
    </message>
    <message>
        <source>There is something in %1 already. Choose a new folder.</source>
        <translation>Ya hay algo en %1. Elija una carpeta nueva.</translation>
    </message>
    <message>
        <source>&amp;Mirror the joint</source>
        <translation>Refle&amp;jar la articulación</translation>
    </message>
    <message>
        <source>Make the joint of the other side of the body: meshes, regions, cages, landmarks, tools and cameras</source>
        <translation>Hacer la articulación del otro lado del cuerpo: mallas, regiones, jaulas, puntos de referencia, herramientas y cámaras</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>&amp;Tour of the shoulder, with tasks</source>
        <translation>&amp;Recorrido del hombro, con tareas</translation>
    </message>
    <message>
        <source>&amp;Landmarks by palpation, with tasks</source>
        <translation>&amp;Puntos de referencia por palpación, con tareas</translation>
    </message>
    <message>
        <source>Save this &amp;run…</source>
        <translation>Guardar este &amp;ejercicio…</translation>
    </message>
    <message>
        <source>Write what the hands did as a recording that can be replayed</source>
        <translation>Escribir lo que hicieron las manos como una grabación que se puede reproducir</translation>
    </message>
    <message>
        <source>Save this run</source>
        <translation>Guardar este ejercicio</translation>
    </message>
    <message>
        <source>Recordings (*.recording)</source>
        <translation>Grabaciones (*.recording)</translation>
    </message>
    <message>
        <source>The run belongs to a scene that is not saved. Save the scene, reset and run again; then the run can be saved.</source>
        <translation>El ejercicio es de una escena que no está guardada. Guarde la escena, reinicie y ejecute de nuevo; entonces se podrá guardar.</translation>
    </message>
    <message>
        <source>There is no run to be saved: nothing was run yet, or the scene was changed while it ran. Reset and run again.</source>
        <translation>No hay ningún ejercicio que guardar: todavía no se ejecutó nada, o la escena cambió durante la ejecución. Reinicie y ejecute de nuevo.</translation>
    </message>
    <message>
        <source>Open a scenario, a joint packed in one file, or a recorded run</source>
        <translation>Abrir un escenario, una articulación en un solo archivo o un ejercicio grabado</translation>
    </message>
    <message>
        <source>Scenarios, joints and recorded runs (*.scenario.json *.jointz joint.json *.recording);;All files (*)</source>
        <translation>Escenarios, articulaciones y ejercicios grabados (*.scenario.json *.jointz joint.json *.recording);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Save joint and scenario where they were opened from</source>
        <translation>Guardar la articulación y el escenario donde se abrieron</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Guardado en %1</translation>
    </message>
    <message>
        <source>The report is in %1</source>
        <translation>El informe está en %1</translation>
    </message>
    <message>
        <source>&amp;Author</source>
        <translation>&amp;Autor</translation>
    </message>
    <message>
        <source>Show what joints and scenes are made with</source>
        <translation>Mostrar lo que sirve para hacer articulaciones y escenas</translation>
    </message>
    <message>
        <source>&amp;Lab</source>
        <translation>&amp;Laboratorio</translation>
    </message>
    <message>
        <source>Show what accuracy costs, what stays stable and what each effect costs</source>
        <translation>Mostrar cuánto cuesta la exactitud, qué sigue estable y cuánto cuesta cada efecto</translation>
    </message>
    <message>
        <source>&amp;Workspace</source>
        <translation>Espacio de &amp;trabajo</translation>
    </message>
    <message>
        <source>Showing a failure of a study in place of the scene</source>
        <translation>Mostrando un fallo de un estudio en lugar de la escena</translation>
    </message>
    <message>
        <source>Through the ar&amp;throscope</source>
        <translation>A través del ar&amp;troscopio</translation>
    </message>
    <message>
        <source>Show what the arthroscope sees beside the view from outside</source>
        <translation>Mostrar lo que ve el artroscopio junto a la vista desde fuera</translation>
    </message>
    <message>
        <source>S&amp;wap arthroscope and outside</source>
        <translation>Inter&amp;cambiar artroscopio y exterior</translation>
    </message>
    <message>
        <source>What is small becomes large; dragged tools follow the mouse in the large picture</source>
        <translation>Lo pequeño pasa a ser grande; las herramientas arrastradas siguen al ratón en la imagen grande</translation>
    </message>
</context>
<context>
    <name>glenoid::NoticeSentences</name>
    <message>
        <source>The effect “%1” is switched on, but no version has it yet: it does nothing.</source>
        <translation>El efecto «%1» está activado, pero ninguna versión lo tiene aún: no hace nada.</translation>
    </message>
    <message>
        <source>Loads are to rise over %1 s, but the scenario has none: the time changes nothing.</source>
        <translation>Las cargas deben crecer durante %1 s, pero el escenario no tiene ninguna: ese tiempo no cambia nada.</translation>
    </message>
    <message>
        <source>The seed %1 changes nothing, since nothing in this version is drawn at random.</source>
        <translation>La semilla %1 no cambia nada, ya que en esta versión nada se sortea.</translation>
    </message>
    <message>
        <source>The effect “%1” is switched on, but the scene holds nothing for it to act on.</source>
        <translation>El efecto «%1» está activado, pero en la escena no hay nada sobre lo que actúe.</translation>
    </message>
    <message>
        <source>“%1” and “%2” lay %3 mm deep in each other at %4 s, beyond the limit of %5 mm: what the run says after that is not to be trusted.</source>
        <translation>«%1» y «%2» estaban hundidos %3 mm uno en otro a los %4 s, más allá del límite de %5 mm: no hay que fiarse de lo que la simulación dice después.</translation>
    </message>
    <message>
        <source>“%1” was carried %2 mm away by step %3 (%4 s), many times its own size of %5 mm: nothing holds it against its loads.</source>
        <translation>«%1» fue arrastrado %2 mm hasta el paso %3 (%4 s), muchas veces su propio tamaño de %5 mm: nada lo sujeta frente a sus cargas.</translation>
    </message>
    <message>
        <source>“%1” was stretched to %2 times its length by step %3 (%4 s), where any tissue is torn: its loads are too large or its material is too soft.</source>
        <translation>«%1» fue estirado a %2 veces su longitud hasta el paso %3 (%4 s), donde cualquier tejido se rompe: sus cargas son demasiado grandes o su material demasiado blando.</translation>
    </message>
    <message>
        <source>The run took longer than %1 s and was stopped at step %2 (%3 s).</source>
        <translation>La simulación duró más de %1 s y se detuvo en el paso %2 (%3 s).</translation>
    </message>
    <message>
        <source>The run took longer than %1 s and was stopped at step %2 (%3 s) with %4 contacts, most of them between “%5” and “%6”.</source>
        <translation>La simulación duró más de %1 s y se detuvo en el paso %2 (%3 s) con %4 contactos, la mayoría entre «%5» y «%6».</translation>
    </message>
    <message>
        <source>The mark “%1” (%2) was missed: nothing pressed with 1 N while it lasted, at steps of %3 ms.</source>
        <translation>La marca «%1» (%2) se perdió: nada apretó con 1 N mientras duró, con pasos de %3 ms.</translation>
    </message>
    <message>
        <source>The steps are too long for the recording: the hand of “%1” passes its path at %2 s by %3 mm, and contact begins at %4 mm.</source>
        <translation>Los pasos son demasiado largos para la grabación: la mano de «%1» se aparta de su camino %3 mm a los %2 s, y el contacto empieza a los %4 mm.</translation>
    </message>
    <message>
        <source>the stiffness of taut tissue against turning is in A</source>
        <translation>la rigidez del tejido tenso frente al giro está en A</translation>
    </message>
    <message>
        <source>the speed at which penetration is undone is capped</source>
        <translation>la velocidad con que se deshace la penetración está limitada</translation>
    </message>
    <message>
        <source>steps that turn too far are cut in parts</source>
        <translation>los pasos que giran demasiado se cortan en partes</translation>
    </message>
    <message>
        <source>contacts are looked for again along unforeseen motion</source>
        <translation>los contactos se buscan de nuevo a lo largo del movimiento imprevisto</translation>
    </message>
    <message>
        <source>B is kept as a matrix</source>
        <translation>B se guarda como matriz</translation>
    </message>
    <message>
        <source>terms of turning levers are left out of ∂F/∂q</source>
        <translation>los términos de brazos que giran se omiten en ∂F/∂q</translation>
    </message>
    <message>
        <source>couplings are springs at points of their regions</source>
        <translation>los acoplamientos son muelles en puntos de sus regiones</translation>
    </message>
    <message>
        <source>In “%1” %2 of %3 elements were turned inside out, most so at step %4 (%5 s): its loads are too large or its material is too soft, and what the run says after that is not to be trusted.</source>
        <translation>En «%1», %2 de %3 elementos quedaron vueltos del revés, los más en el paso %4 (%5 s): sus cargas son demasiado grandes o su material es demasiado blando, y no hay que fiarse de lo que la simulación dice después.</translation>
    </message>
    <message>
        <source>In “%1” %2 of %3 elements were pressed beyond three times their Young&apos;s modulus, most so at step %4 (%5 s): no law of this kind holds tissue that is pressed so hard.</source>
        <translation>En «%1», %2 de %3 elementos fueron comprimidos más allá de tres veces su módulo de Young, los más en el paso %4 (%5 s): ninguna ley de esta clase sostiene un tejido tan comprimido.</translation>
    </message>
    <message>
        <source>overstretched and crushed tissue leaves the linear law</source>
        <translation>el tejido demasiado estirado o aplastado deja la ley lineal</translation>
    </message>
    <message>
        <source>“%1” lay %2 mm deep in itself at %3 s, beyond the limit of %4 mm: what the run says after that is not to be trusted.</source>
        <translation>«%1» estaba %2 mm dentro de sí mismo a los %3 s, por encima del límite de %4 mm: lo que la ejecución diga después no es de fiar.</translation>
    </message>
    <message>
        <source>In %1 of %2 steps, first at step %3 (%4 s), contacts would have cost more than a step may: some of them were left out or the step was taken in fewer parts, so what parts do to each other there is only roughly right.</source>
        <translation>En %1 de %2 pasos, el primero el %3 (%4 s), los contactos habrían costado más de lo que un paso puede: algunos se dejaron fuera o el paso se dividió en menos partes, así que lo que las piezas se hacen unas a otras es ahí solo aproximado.</translation>
    </message>
</context>
<context>
    <name>glenoid::NoticeStrip</name>
    <message>
        <source>Show everything that is to be said about this run in the list of problems</source>
        <translation>Mostrar en la lista de problemas todo lo que hay que decir de esta ejecución</translation>
    </message>
    <message>
        <source>Close the notice</source>
        <translation>Cerrar el aviso</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n más</numerusform>
            <numerusform>%n más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::PartEdits</name>
    <message>
        <source>Rename “%1”</source>
        <translation>Cambiar el nombre de «%1»</translation>
    </message>
    <message>
        <source>Number “%1”</source>
        <translation>Numerar «%1»</translation>
    </message>
    <message>
        <source>Make “%1” soft</source>
        <translation>Hacer blando «%1»</translation>
    </message>
    <message>
        <source>Make “%1” rigid</source>
        <translation>Hacer rígido «%1»</translation>
    </message>
    <message>
        <source>Colour “%1”</source>
        <translation>Colorear «%1»</translation>
    </message>
    <message>
        <source>Change the materials of “%1”</source>
        <translation>Cambiar los materiales de «%1»</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Añadir «%1»</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>Quitar «%1»</translation>
    </message>
    <message>
        <source>Replace the visual surface of “%1”</source>
        <translation>Sustituir la superficie visual de «%1»</translation>
    </message>
    <message>
        <source>Replace the collision surface of “%1”</source>
        <translation>Sustituir la superficie de colisión de «%1»</translation>
    </message>
    <message>
        <source>Embed “%1” in other cells</source>
        <translation>Embeber «%1» en otras celdas</translation>
    </message>
    <message>
        <source>Add the material “%1”</source>
        <translation>Añadir el material «%1»</translation>
    </message>
    <message>
        <source>Change the material “%1”</source>
        <translation>Cambiar el material «%1»</translation>
    </message>
    <message>
        <source>Remove the material “%1”</source>
        <translation>Quitar el material «%1»</translation>
    </message>
    <message>
        <source>Switch off contact between “%1” and “%2”</source>
        <translation>Desactivar el contacto entre «%1» y «%2»</translation>
    </message>
    <message>
        <source>Switch on contact between “%1” and “%2”</source>
        <translation>Activar el contacto entre «%1» y «%2»</translation>
    </message>
    <message>
        <source>Change the elements of “%1”</source>
        <translation>Cambiar los elementos de «%1»</translation>
    </message>
    <message>
        <source>Move “%1”</source>
        <translation>Mover «%1»</translation>
    </message>
</context>
<context>
    <name>glenoid::PartMovement</name>
    <message>
        <source>Fix “%1” in the room</source>
        <translation>Fijar «%1» en la sala</translation>
    </message>
    <message>
        <source>Hold “%1” by a spring</source>
        <translation>Sujetar «%1» con un muelle</translation>
    </message>
    <message>
        <source>Let “%1” move freely</source>
        <translation>Dejar que «%1» se mueva libremente</translation>
    </message>
    <message>
        <source>Let “%1” touch itself</source>
        <translation>Dejar que «%1» se toque a sí mismo</translation>
    </message>
    <message>
        <source>Let “%1” pass through itself</source>
        <translation>Dejar que «%1» se atraviese a sí mismo</translation>
    </message>
</context>
<context>
    <name>glenoid::PartTree</name>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Parts and tools</source>
        <translation>Partes y herramientas</translation>
    </message>
    <message>
        <source>Check a part to see it; click selects, Ctrl and Shift select several.</source>
        <translation>Marque una parte para verla; un clic selecciona, Ctrl y Mayús seleccionan varias.</translation>
    </message>
    <message>
        <source>&amp;Opacity</source>
        <translation>&amp;Opacidad</translation>
    </message>
    <message>
        <source>Opacity of the selected parts</source>
        <translation>Opacidad de las partes seleccionadas</translation>
    </message>
    <message>
        <source>How solid the selected parts are drawn</source>
        <translation>Cuán sólidas se dibujan las partes seleccionadas</translation>
    </message>
    <message>
        <source>S&amp;olo</source>
        <translation>S&amp;olo esto</translation>
    </message>
    <message>
        <source>Show only the selected parts</source>
        <translation>Mostrar solo las partes seleccionadas</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>Mostr&amp;ar todo</translation>
    </message>
    <message>
        <source>Make every part visible and solid again</source>
        <translation>Volver a mostrar todas las partes, sólidas</translation>
    </message>
    <message>
        <source>Rigid parts</source>
        <translation>Partes rígidas</translation>
    </message>
    <message>
        <source>Soft parts</source>
        <translation>Partes blandas</translation>
    </message>
</context>
<context>
    <name>glenoid::PlaceFields</name>
    <message>
        <source>Place</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Shift, mm:</source>
        <translation>Desplazar, mm:</translation>
    </message>
    <message>
        <source>Shift along X</source>
        <translation>Desplazar a lo largo de X</translation>
    </message>
    <message>
        <source>Shift along Y</source>
        <translation>Desplazar a lo largo de Y</translation>
    </message>
    <message>
        <source>Shift along Z</source>
        <translation>Desplazar a lo largo de Z</translation>
    </message>
    <message>
        <source>Turn, °:</source>
        <translation>Girar, °:</translation>
    </message>
    <message>
        <source>Turn about X</source>
        <translation>Girar alrededor de X</translation>
    </message>
    <message>
        <source>Turn about Y</source>
        <translation>Girar alrededor de Y</translation>
    </message>
    <message>
        <source>Turn about Z</source>
        <translation>Girar alrededor de Z</translation>
    </message>
    <message>
        <source>Scale:</source>
        <translation>Escala:</translation>
    </message>
    <message>
        <source>Put it there</source>
        <translation>Ponerla ahí</translation>
    </message>
    <message>
        <source>Turn and scale about the middle of the part, about X, then Y, then Z, then shift it. Regions stay; its cage goes</source>
        <translation>Gira y escala alrededor del centro de la pieza, en torno a X, luego Y, luego Z, y después la desplaza. Las regiones se quedan; su jaula se quita</translation>
    </message>
</context>
<context>
    <name>glenoid::ProblemSentences</name>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>collision surface</source>
        <translation>superficie de colisión</translation>
    </message>
    <message>
        <source>visual surface</source>
        <translation>superficie visual</translation>
    </message>
    <message>
        <source>The largest part is %1 m long, which no human joint is: its meshes are probably in another unit. Multiplied by %2 they would be metres.</source>
        <translation>La parte más grande mide %1 m, lo que no mide ninguna articulación humana: sus mallas están probablemente en otra unidad. Multiplicadas por %2 serían metros.</translation>
    </message>
    <message>
        <source>“%1” is %2 m long, unlike the other parts: it is probably in another unit. Multiplied by %3 it would be in metres.</source>
        <translation>«%1» mide %2 m, a diferencia de las demás partes: está probablemente en otra unidad. Multiplicada por %3 estaría en metros.</translation>
    </message>
    <message>
        <source>“%1” has no usable %2. Bring its mesh in again.</source>
        <translation>«%1» no tiene una %2 utilizable. Importe de nuevo su malla.</translation>
    </message>
    <message>
        <source>The %2 of “%1” is not closed (open edges: %3). Close its holes, so that inside and outside can be told apart.</source>
        <translation>La %2 de «%1» no está cerrada (aristas abiertas: %3). Cierre sus agujeros para que se distinga el interior del exterior.</translation>
    </message>
    <message>
        <source>The %2 of “%1” is no clean surface (edges, vertices or triangles at fault: %3). Repair the mesh and bring it in again.</source>
        <translation>La %2 de «%1» no es una superficie limpia (aristas, vértices o triángulos defectuosos: %3). Repare la malla e impórtela de nuevo.</translation>
    </message>
    <message>
        <source>The %2 of “%1” is wound inwards, so that its outside is inside. Turn its triangles around.</source>
        <translation>La %2 de «%1» está orientada hacia dentro, de modo que su exterior es el interior. Dé la vuelta a sus triángulos.</translation>
    </message>
    <message>
        <source>The %2 of “%1” cuts itself (pairs of triangles: %3, the first at triangle %4), which makes contacts push the wrong way. Simplify it again or repair it.</source>
        <translation>La %2 de «%1» se corta a sí misma (pares de triángulos: %3, el primero en el triángulo %4), lo que hace que los contactos empujen en sentido contrario. Simplifíquela de nuevo o repárela.</translation>
    </message>
    <message>
        <source>The %2 of “%1” cuts itself (pairs of triangles: %3, the first at triangle %4). It is drawn wrong there; nothing else comes of it.</source>
        <translation>La %2 de «%1» se corta a sí misma (pares de triángulos: %3, el primero en el triángulo %4). Allí se dibuja mal; no tiene otra consecuencia.</translation>
    </message>
    <message>
        <source>“%1” is soft and has no usable tetrahedra. Embed it in cells.</source>
        <translation>«%1» es blando y no tiene tetraedros utilizables. Embébalo en celdas.</translation>
    </message>
    <message>
        <source>“%1” has tetrahedra without volume (%2, the worst is number %3). Embed it again with another cell size.</source>
        <translation>«%1» tiene tetraedros sin volumen (%2, el peor es el número %3). Embébalo de nuevo con otro tamaño de celda.</translation>
    </message>
    <message>
        <source>“%1” has tetrahedra that are inside out (%2, the worst is number %3). Turn their corners around.</source>
        <translation>«%1» tiene tetraedros vueltos del revés (%2, el peor es el número %3). Dé la vuelta a sus vértices.</translation>
    </message>
    <message>
        <source>“%1” has no material. Choose one.</source>
        <translation>«%1» no tiene material. Elija uno.</translation>
    </message>
    <message>
        <source>“%1” has the material “%2”, which does not exist. Choose another.</source>
        <translation>«%1» tiene el material «%2», que no existe. Elija otro.</translation>
    </message>
    <message>
        <source>The coupling “%1” names a part or a region that is not there (region “%2”). Paint its region again, or remove it.</source>
        <translation>El acoplamiento «%1» nombra una parte o una región que no existe (región «%2»). Pinte de nuevo su región o quítelo.</translation>
    </message>
    <message>
        <source>The coupling “%1” between “%2” and “%3” cannot hold: its region is a line or empty (%4 mm wide), and the parts would turn about it freely. Enlarge its region.</source>
        <translation>El acoplamiento «%1» entre «%2» y «%3» no puede sujetar: su región es una línea o está vacía (%4 mm de ancho) y las partes girarían libremente en torno a ella. Amplíe su región.</translation>
    </message>
    <message>
        <source>The region of the coupling “%1” between “%2” and “%3” is too small for its stiffness: %4 N/mm on %5 mm² is %6 N/mm per cm², more than a layer of 0.1 mm of the softer tissue. A layer of 1 mm has %7 N/mm per cm²: enlarge the region to some %8 mm², or lower the stiffness.</source>
        <translation>La región del acoplamiento «%1» entre «%2» y «%3» es demasiado pequeña para su rigidez: %4 N/mm en %5 mm² son %6 N/mm por cm², más que una capa de 0,1 mm del tejido más blando. Una capa de 1 mm tiene %7 N/mm por cm²: amplíe la región a unos %8 mm² o reduzca la rigidez.</translation>
    </message>
    <message>
        <source>Nothing holds “%1”: it has no coupling and will fall. The nearest part is %2 mm away.</source>
        <translation>Nada sujeta «%1»: no tiene acoplamiento y caerá. La parte más cercana está a %2 mm.</translation>
    </message>
    <message>
        <source>Nothing holds “%1”: it has no coupling and will fall.</source>
        <translation>Nada sujeta «%1»: no tiene acoplamiento y caerá.</translation>
    </message>
    <message>
        <source>These parts are coupled to each other and to nothing that stays: %1. They will fall together. Couple one of them to a bone, or hold it.</source>
        <translation>Estas partes están acopladas entre sí y a nada que se quede quieto: %1. Caerán juntas. Acople una de ellas a un hueso o sujétela.</translation>
    </message>
    <message>
        <source>The cage around “%1” cannot be used. %2</source>
        <translation>La jaula de «%1» no se puede usar. %2</translation>
    </message>
    <message>
        <source>The cage squeezes “%1” too much: %2 tetrahedra keep less than a tenth of their volume, the worst (number %3) keeps %4 %. Moving the handles back to %5 % of their way is enough.</source>
        <translation>La jaula comprime demasiado «%1»: %2 tetraedros conservan menos de la décima parte de su volumen, el peor (número %3) conserva el %4 %. Basta con devolver los tiradores al %5 % de su recorrido.</translation>
    </message>
    <message>
        <source>The cage turns tetrahedra of “%1” inside out (too little volume: %2, the worst is number %3). Moving the handles back to %4 % of their way is enough.</source>
        <translation>La jaula vuelve del revés tetraedros de «%1» (con demasiado poco volumen: %2, el peor es el número %3). Basta con devolver los tiradores al %4 % de su recorrido.</translation>
    </message>
    <message>
        <source>“%1” and “%2” cut each other at the start (pairs of triangles: %3, deepest %4 mm). Separate them with cages, or switch off their contact.</source>
        <translation>«%1» y «%2» se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm). Sepárelos con jaulas o desactive su contacto.</translation>
    </message>
    <message>
        <source>“%1” starts wholly inside “%2” (deepest %3 mm). Move it out, or switch off their contact.</source>
        <translation>«%1» comienza por completo dentro de «%2» (profundidad máxima %3 mm). Sáquelo o desactive su contacto.</translation>
    </message>
    <message>
        <source>No two parts cut each other at the start, but the joint does not record it. Recording it lets others trust it.</source>
        <translation>Ningún par de partes se corta al comienzo, pero la articulación no lo registra. Registrarlo permite que otros se fíen.</translation>
    </message>
    <message>
        <source>The recorded proof of the start belongs to other meshes, cages or contacts. Check the start again.</source>
        <translation>La prueba registrada del comienzo corresponde a otras mallas, jaulas o contactos. Compruebe de nuevo el comienzo.</translation>
    </message>
    <message>
        <source>A setting of the scenario changes nothing.</source>
        <translation>Un ajuste del escenario no cambia nada.</translation>
    </message>
    <message>
        <source>The joint cannot be saved as it is.</source>
        <translation>La articulación no se puede guardar tal como está.</translation>
    </message>
    <message>
        <source>Multiply all lengths by %1</source>
        <translation>Multiplicar todas las longitudes por %1</translation>
    </message>
    <message>
        <source>Multiply the lengths of “%1” by %2</source>
        <translation>Multiplicar las longitudes de «%1» por %2</translation>
    </message>
    <message>
        <source>Turn the %2 of “%1” around</source>
        <translation>Dar la vuelta a la %2 de «%1»</translation>
    </message>
    <message>
        <source>Turn the tetrahedra of “%1” around</source>
        <translation>Dar la vuelta a los tetraedros de «%1»</translation>
    </message>
    <message>
        <source>Give “%1” the material “%2”</source>
        <translation>Dar a «%1» el material «%2»</translation>
    </message>
    <message>
        <source>Remove the coupling “%1”</source>
        <translation>Quitar el acoplamiento «%1»</translation>
    </message>
    <message>
        <source>Enlarge the region of the coupling “%1”</source>
        <translation>Ampliar la región del acoplamiento «%1»</translation>
    </message>
    <message>
        <source>Lower the stiffness of the coupling “%1” to %2 N/mm per cm²</source>
        <translation>Reducir la rigidez del acoplamiento «%1» a %2 N/mm por cm²</translation>
    </message>
    <message>
        <source>Switch off contact between “%1” and “%2”</source>
        <translation>Desactivar el contacto entre «%1» y «%2»</translation>
    </message>
    <message>
        <source>Move the handles around “%1” back</source>
        <translation>Devolver los tiradores de «%1»</translation>
    </message>
    <message>
        <source>Separate “%1” and “%2” with cages</source>
        <translation>Separar «%1» y «%2» con jaulas</translation>
    </message>
    <message>
        <source>Record that the start is free of overlap</source>
        <translation>Registrar que el comienzo está libre de solapamientos</translation>
    </message>
    <message>
        <source>Check the start again</source>
        <translation>Comprobar de nuevo el comienzo</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Remove the cage around “%1”</source>
        <translation>Quitar la jaula alrededor de «%1»</translation>
    </message>
    <message>
        <source>“%1” and “%2” are bonded over a large surface (%3 mm²) and still tested for contact. Switching that off saves time and spares contacts that pull against the bond.</source>
        <translation>«%1» y «%2» están unidos en una superficie grande (%3 mm²) y aún se busca contacto entre ellos. Desactivarlo ahorra tiempo y evita contactos que tiran contra la unión.</translation>
    </message>
    <message>
        <source>Repair the %2 of “%1”</source>
        <translation>Reparar la %2 de «%1»</translation>
    </message>
    <message>
        <source>“%1” hangs, and the weight below its weakest part will stretch that to %2 times its length, if nothing lies under it. Couple its other end too, or give that part a stiffer material (%3 kPa or more).</source>
        <translation>«%1» cuelga, y el peso bajo su parte más débil la estirará a %2 veces su longitud, si nada la sostiene por debajo. Una también su otro extremo, o dé a esa parte un material más rígido (%3 kPa o más).</translation>
    </message>
    <message>
        <source>“%1” and “%2” are rigid and cut each other at the start (pairs of triangles: %3, deepest %4 mm), as their visual surfaces do. Move one of them, or switch off their contact.</source>
        <translation>«%1» y «%2» son rígidas y se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm), igual que sus superficies visuales. Mueva una de ellas o desactive su contacto.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest %4 mm) where the visual ones do not. With %5 triangles each they do not cut, nor as they are with a clearance of %6 mm in the recipe.</source>
        <translation>«%1» y «%2» son rígidas, y sus superficies de colisión se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm) donde las visuales no lo hacen. Con %5 triángulos cada una no se cortan, ni tal como están con una holgura («clearance») de %6 mm en la receta.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest %4 mm) where the visual ones do not. With %5 triangles each they do not cut.</source>
        <translation>«%1» y «%2» son rígidas, y sus superficies de colisión se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm) donde las visuales no lo hacen. Con %5 triángulos cada una no se cortan.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are rigid, and their collision surfaces cut each other at the start (pairs of triangles: %3, deepest %4 mm) where the visual ones do not. With a clearance of %6 mm in the recipe they do not cut.</source>
        <translation>«%1» y «%2» son rígidas, y sus superficies de colisión se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm) donde las visuales no lo hacen. Con una holgura («clearance») de %6 mm en la receta no se cortan.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are rigid and cut each other at the start (pairs of triangles: %3, deepest %4 mm); neither more triangles nor a clearance keeps them apart. Move one of them, or switch off their contact.</source>
        <translation>«%1» y «%2» son rígidas y se cortan al comienzo (pares de triángulos: %3, profundidad máxima %4 mm); ni más triángulos ni una holgura las mantienen separadas. Mueva una de ellas o desactive su contacto.</translation>
    </message>
    <message>
        <source>Simplify “%1” and “%2” again, to %3 triangles each</source>
        <translation>Simplificar de nuevo «%1» y «%2», a %3 triángulos cada una</translation>
    </message>
    <message>
        <source>The spring that holds “%1” would swing %2 times a second, and steps this long damp it out at once. Steps of %3 ms or less show it swing; otherwise soften the spring or give it the damping that is meant.</source>
        <translation>El muelle que sujeta «%1» oscilaría %2 veces por segundo, y pasos tan largos lo amortiguan de inmediato. Con pasos de %3 ms o menos se lo ve oscilar; si no, ablande el muelle o dele la amortiguación que se pretende.</translation>
    </message>
    <message>
        <source>The cage moves “%1” by up to %2 mm, farther than the part is thick (%3 mm): it may start on the wrong side of a neighbour. Look at its start, and move the cage by hand or bring better surfaces in.</source>
        <translation>La jaula mueve «%1» hasta %2 mm, más que el grosor de la pieza (%3 mm): puede empezar en el lado equivocado de una vecina. Mire su comienzo y mueva la jaula a mano o traiga superficies mejores.</translation>
    </message>
    <message>
        <source>The cage squeezes “%1”: %2 tetrahedra keep less than %3 % of their volume, the worst (number %4) keeps %5 %. They will push back when the run begins. Use a smaller clearance or a cage with more handles.</source>
        <translation>La jaula aprieta «%1»: %2 tetraedros conservan menos del %3 % de su volumen, el peor (número %4) conserva el %5 %. Empujarán cuando empiece la simulación. Use una holgura menor o una jaula con más tiradores.</translation>
    </message>
    <message>
        <source>The coupling “%1” names a part or nodes of cells that are not there (nodes: %2). Pick its nodes again, or remove it.</source>
        <translation>El acoplamiento «%1» nombra una pieza o nodos de celdas que no existen (nodos: %2). Elija de nuevo sus nodos o quítelo.</translation>
    </message>
    <message>
        <source>The coupling “%1” between “%2” and “%3” cannot hold. %4</source>
        <translation>El acoplamiento «%1» entre «%2» y «%3» no puede sujetar. %4</translation>
    </message>
    <message>
        <source>Add the nodes around those of the coupling “%1”</source>
        <translation>Añadir los nodos que rodean a los del acoplamiento «%1»</translation>
    </message>
</context>
<context>
    <name>glenoid::ProblemsPanel</name>
    <message>
        <source>Problems of the joint</source>
        <translation>Problemas de la articulación</translation>
    </message>
    <message>
        <source>Looking for problems…</source>
        <translation>Buscando problemas…</translation>
    </message>
    <message>
        <source>No scene is open.</source>
        <translation>No hay ninguna escena abierta.</translation>
    </message>
    <message>
        <source>No problems were found.</source>
        <translation>No se han encontrado problemas.</translation>
    </message>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n nota</numerusform>
            <numerusform>%n notas</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Arreglar</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>Arreglar: %1</translation>
    </message>
    <message>
        <source>This one needs your judgement.</source>
        <translation>Este requiere su criterio.</translation>
    </message>
    <message>
        <source>Of this run</source>
        <translation>De esta ejecución</translation>
    </message>
    <message numerus="yes">
        <source>%n notice(s) about the run</source>
        <translation>
            <numerusform>%n aviso sobre la ejecución</numerusform>
            <numerusform>%n avisos sobre la ejecución</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>glenoid::PropertiesPanel</name>
    <message>
        <source>No scene is open. Choose File ▸ Open… to begin, or File ▸ Import surfaces… to make a joint of your own.</source>
        <translation>No hay ninguna escena abierta. Elija Archivo ▸ Abrir… para empezar, o Archivo ▸ Importar superficies… para hacer una articulación propia.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Parts:</source>
        <translation>Partes:</translation>
    </message>
    <message>
        <source>Visual triangles:</source>
        <translation>Triángulos visuales:</translation>
    </message>
    <message>
        <source>Tetrahedra:</source>
        <translation>Tetraedros:</translation>
    </message>
    <message>
        <source>Couplings:</source>
        <translation>Acoplamientos:</translation>
    </message>
    <message>
        <source>Time step:</source>
        <translation>Paso de tiempo:</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1:</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Parte</translation>
    </message>
    <message>
        <source>Number:</source>
        <translation>Número:</translation>
    </message>
    <message>
        <source>Kind:</source>
        <translation>Tipo:</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>blanda</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>rígida</translation>
    </message>
    <message>
        <source>Collision triangles:</source>
        <translation>Triángulos de colisión:</translation>
    </message>
    <message>
        <source>Nodes:</source>
        <translation>Nodos:</translation>
    </message>
    <message>
        <source>Cell size:</source>
        <translation>Tamaño de celda:</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Size:</source>
        <translation>Tamaño:</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Mass:</source>
        <translation>Masa:</translation>
    </message>
    <message>
        <source>%1 g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>Material: %1</source>
        <translation>Material: %1</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>Dónde:</translation>
    </message>
    <message>
        <source>Density:</source>
        <translation>Densidad:</translation>
    </message>
    <message>
        <source>%1 kg/m³</source>
        <translation>%1 kg/m³</translation>
    </message>
    <message>
        <source>kPa</source>
        <translation>kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of %1</source>
        <translation>Módulo de Young de %1</translation>
    </message>
    <message>
        <source>How hard it is to stretch. Every part made of this material changes with it.</source>
        <translation>Cuánto cuesta estirarlo. Todas las partes de este material cambian con él.</translation>
    </message>
    <message>
        <source>Young&apos;s modulus:</source>
        <translation>Módulo de Young:</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio:</source>
        <translation>Coeficiente de Poisson:</translation>
    </message>
    <message>
        <source>Friction:</source>
        <translation>Rozamiento:</translation>
    </message>
    <message>
        <source>Literature:</source>
        <translation>Literatura:</translation>
    </message>
    <message>
        <source>%1 kPa</source>
        <translation>%1 kPa</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Fuente: %1</translation>
    </message>
    <message>
        <source>Coupled to %1</source>
        <translation>Acoplada a %1</translation>
    </message>
    <message>
        <source>Over:</source>
        <translation>Sobre:</translation>
    </message>
    <message>
        <source>Area:</source>
        <translation>Área:</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>N/mm per cm²</source>
        <translation>N/mm por cm²</translation>
    </message>
    <message>
        <source>Stiffness of the coupling</source>
        <translation>Rigidez del acoplamiento</translation>
    </message>
    <message>
        <source>Stiffness:</source>
        <translation>Rigidez:</translation>
    </message>
    <message>
        <source>Springs:</source>
        <translation>Muelles:</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Length:</source>
        <translation>Longitud:</translation>
    </message>
    <message>
        <source>Diameter:</source>
        <translation>Diámetro:</translation>
    </message>
    <message>
        <source>Hand stiffness:</source>
        <translation>Rigidez de la mano:</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>Largest pull:</source>
        <translation>Tirón máximo:</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Movement:</source>
        <translation>Movimiento:</translation>
    </message>
    <message>
        <source>Movement of the part</source>
        <translation>Movimiento de la parte</translation>
    </message>
    <message>
        <source>Whether the part stays where it is, is pulled back by a spring, or moves freely</source>
        <translation>Si la parte se queda donde está, un muelle la devuelve o se mueve libremente</translation>
    </message>
    <message>
        <source>fixed in the room</source>
        <translation>fija en la sala</translation>
    </message>
    <message>
        <source>held by a spring</source>
        <translation>sujeta por un muelle</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation>Color:</translation>
    </message>
    <message>
        <source>Name of the part</source>
        <translation>Nombre de la parte</translation>
    </message>
    <message>
        <source>Number of the part</source>
        <translation>Número de la parte</translation>
    </message>
    <message>
        <source>As printed in tables; no two parts have the same</source>
        <translation>Como aparece en las tablas; no hay dos partes con el mismo</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Colour of the part</source>
        <translation>Color de la parte</translation>
    </message>
    <message>
        <source>State:</source>
        <translation>Estado:</translation>
    </message>
    <message>
        <source>At rest: the loads are whole and no part moves faster than %1 mm/s</source>
        <translation>En reposo: las cargas están completas y ninguna pieza se mueve a más de %1 mm/s</translation>
    </message>
    <message>
        <source>not run yet</source>
        <translation>aún no se ha ejecutado</translation>
    </message>
    <message>
        <source>loads are rising</source>
        <translation>las cargas están creciendo</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>moving at up to %1 mm/s</source>
        <translation>en movimiento, a %1 mm/s como máximo</translation>
    </message>
    <message>
        <source>Elements:</source>
        <translation>Elementos:</translation>
    </message>
    <message>
        <source>Elements of the part</source>
        <translation>Elementos de la pieza</translation>
    </message>
    <message>
        <source>Five tetrahedra in each cell, or whole cells, which bend where the tissue is thinner than a cell</source>
        <translation>Cinco tetraedros en cada celda, o celdas enteras, que se doblan donde el tejido es más delgado que una celda</translation>
    </message>
    <message>
        <source>tetrahedra</source>
        <translation>tetraedros</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>celdas</translation>
    </message>
    <message>
        <source>Self-contact:</source>
        <translation>Autocontacto:</translation>
    </message>
    <message>
        <source>touches itself</source>
        <translation>se toca a sí misma</translation>
    </message>
    <message>
        <source>Self-contact of the part</source>
        <translation>Autocontacto de la parte</translation>
    </message>
    <message>
        <source>Whether the part may fold onto itself without passing through; it costs time in every step</source>
        <translation>Si la parte puede plegarse sobre sí misma sin atravesarse; cuesta tiempo en cada paso</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Articulación</translation>
    </message>
    <message>
        <source>Name of the joint</source>
        <translation>Nombre de la articulación</translation>
    </message>
    <message>
        <source>Description:</source>
        <translation>Descripción:</translation>
    </message>
    <message>
        <source>What the joint is and what it is for</source>
        <translation>Qué es la articulación y para qué sirve</translation>
    </message>
    <message>
        <source>Author:</source>
        <translation>Autoría:</translation>
    </message>
    <message>
        <source>Who made the joint</source>
        <translation>Quién hizo la articulación</translation>
    </message>
    <message>
        <source>Licence:</source>
        <translation>Licencia:</translation>
    </message>
    <message>
        <source>Under which terms the joint may be used, such as CC-BY-4.0</source>
        <translation>En qué condiciones se puede usar la articulación, por ejemplo CC-BY-4.0</translation>
    </message>
    <message>
        <source>Side:</source>
        <translation>Lado:</translation>
    </message>
    <message>
        <source>Side of the body</source>
        <translation>Lado del cuerpo</translation>
    </message>
    <message>
        <source>On which side of the body the joint lies: lateral and medial follow it. Edit ▸ Mirror the joint makes the joint of the other side.</source>
        <translation>En qué lado del cuerpo está la articulación: lateral y medial lo siguen. Editar ▸ Reflejar la articulación hace la del otro lado.</translation>
    </message>
    <message>
        <source>none said</source>
        <translation>sin indicar</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierdo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecho</translation>
    </message>
    <message numerus="yes">
        <source>%n picked node(s)</source>
        <translation>
            <numerusform>%n nodo elegido</numerusform>
            <numerusform>%n nodos elegidos</numerusform>
        </translation>
    </message>
    <message>
        <source>N/mm per node</source>
        <translation>N/mm por nodo</translation>
    </message>
</context>
<context>
    <name>glenoid::RecoverDialog</name>
    <message>
        <source>Remove the safety copies</source>
        <translation>Quitar las copias de seguridad</translation>
    </message>
    <message>
        <source>Remove every safety copy of this scene? This cannot be undone.</source>
        <translation>¿Quitar todas las copias de seguridad de esta escena? No se puede deshacer.</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recuperar trabajo sin guardar</translation>
    </message>
    <message>
        <source>These scenes had changes that were not saved when the program ended. Your own files are as you last saved them. Whatever you do not recover now can be found again under File &gt; Recover.</source>
        <translation>Estas escenas tenían cambios sin guardar cuando terminó el programa. Sus propios archivos están como los guardó por última vez. Lo que no recupere ahora se puede encontrar de nuevo en Archivo &gt; Recuperar.</translation>
    </message>
    <message>
        <source>Scenes that can be recovered</source>
        <translation>Escenas que se pueden recuperar</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Guardada</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Opened from</source>
        <translation>Abierta desde</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>&amp;Recuperar</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>A&amp;hora no</translation>
    </message>
    <message>
        <source>Remove &amp;copies</source>
        <translation>Quitar las &amp;copias</translation>
    </message>
    <message>
        <source>yyyy-MM-dd HH:mm:ss</source>
        <translation>dd/MM/yyyy HH:mm:ss</translation>
    </message>
    <message>
        <source>Without a name</source>
        <translation>Sin nombre</translation>
    </message>
    <message>
        <source>New scene</source>
        <translation>Escena nueva</translation>
    </message>
</context>
<context>
    <name>glenoid::Report</name>
    <message>
        <source>Figure %1. %2</source>
        <translation>Figura %1. %2</translation>
    </message>
    <message>
        <source>Table %1. %2</source>
        <translation>Tabla %1. %2</translation>
    </message>
</context>
<context>
    <name>glenoid::ReportAccuracy</name>
    <message>
        <source>What accuracy costs: %1, %2</source>
        <translation>Lo que cuesta la exactitud: %1, %2</translation>
    </message>
    <message>
        <source>Error against %1. Lower left is better. Whiskers reach up to 95 of 100 steps; hollow: compared in fewer moments.</source>
        <translation>Error frente a %1. Abajo a la izquierda es mejor. Los bigotes llegan a 95 de cada 100 pasos; hueco: comparado en menos momentos.</translation>
    </message>
    <message>
        <source>Error of %1, mm</source>
        <translation>Error de %1, mm</translation>
    </message>
    <message>
        <source>Error of %1, N</source>
        <translation>Error de %1, N</translation>
    </message>
    <message>
        <source>Computing time for each %1 ms that are simulated, ms</source>
        <translation>Tiempo de cálculo por cada %1 ms simulados, ms</translation>
    </message>
    <message>
        <source>below the reference’s own error: no difference can be told</source>
        <translation>por debajo del error propio de la referencia: no se distingue nada</translation>
    </message>
    <message>
        <source>twice that</source>
        <translation>el doble</translation>
    </message>
    <message>
        <source>%1 (real time)</source>
        <translation>%1 (tiempo real)</translation>
    </message>
    <message>
        <source>No error to draw</source>
        <translation>Sin error que dibujar</translation>
    </message>
    <message>
        <source>no other is both faster and nearer</source>
        <translation>ninguno es a la vez más rápido y más cercano</translation>
    </message>
    <message>
        <source>The setting nearest to the reference by displacement that stays within a budget in 95 of 100 steps; errors against %1.</source>
        <translation>El ajuste más cercano a la referencia en desplazamiento que cabe en un presupuesto en 95 de cada 100 pasos; errores frente a %1.</translation>
    </message>
    <message>
        <source>Budget</source>
        <translation>Presupuesto</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>95 of 100</source>
        <translation>95 de 100</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>tal como está</translation>
    </message>
    <message>
        <source>All settings by time. Errors of displacement against the same cells in very small steps and against finer cells, and of contact force; those that failed with their reason.</source>
        <translation>Todos los ajustes por tiempo. Errores de desplazamiento frente a las mismas celdas en pasos muy pequeños y frente a celdas más finas, y de fuerza de contacto; los que fallaron, con su motivo.</translation>
    </message>
    <message>
        <source>Displacement, same cells</source>
        <translation>Desplazamiento, mismas celdas</translation>
    </message>
    <message>
        <source>Displacement, finer cells</source>
        <translation>Desplazamiento, celdas más finas</translation>
    </message>
    <message>
        <source>Contact force, same cells</source>
        <translation>Fuerza de contacto, mismas celdas</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Observación</translation>
    </message>
    <message>
        <source>no scenario can say it</source>
        <translation>ningún escenario puede expresarlo</translation>
    </message>
    <message>
        <source>%1: the study holds no errors to choose by.</source>
        <translation>%1: el estudio no contiene errores con los que elegir.</translation>
    </message>
    <message>
        <source>%1: no setting stays within %2 in 95 of 100 steps; the cheapest takes %3.</source>
        <translation>%1: ningún ajuste cabe en %2 en 95 de cada 100 pasos; el más barato tarda %3.</translation>
    </message>
    <message>
        <source>For %1 of computing to each %2 of simulated time, run %3 with this setting: %4.</source>
        <translation>Para %1 de cálculo por cada %2 de tiempo simulado, use %3 con este ajuste: %4.</translation>
    </message>
    <message>
        <source>It costs %1 (median; %2 in 95 of 100 steps) and lies %3 of displacement away from the same scene solved in very small steps.</source>
        <translation>Cuesta %1 (mediana; %2 en 95 de cada 100 pasos) y queda a %3 de desplazamiento de la misma escena resuelta en pasos muy pequeños.</translation>
    </message>
    <message>
        <source>That is within the reference’s own error, %1: nearer cannot be told.</source>
        <translation>Eso está dentro del error propio de la referencia, %1: más cerca no se puede distinguir.</translation>
    </message>
    <message>
        <source>The scene as it is costs %1 and lies %2 away.</source>
        <translation>La escena tal como está cuesta %1 y queda a %2.</translation>
    </message>
    <message>
        <source>What its cells leave out beside that is not a matter of solving: against finer cells it lies %1 away.</source>
        <translation>Lo que dejan fuera sus celdas no depende de la resolución: frente a celdas más finas queda a %1.</translation>
    </message>
    <message>
        <source>Nearest to finer cells within the same time is: %1, at %2 and %3.</source>
        <translation>Lo más cercano a las celdas más finas en el mismo tiempo es: %1, con %2 y %3.</translation>
    </message>
    <message>
        <source>What accuracy costs: %1</source>
        <translation>Lo que cuesta la exactitud: %1</translation>
    </message>
    <message>
        <source>From the same moments of the run, the scene is stepped under many settings. Each is a point: how long it computes, and how far it then lies from a reference that was refined until it hardly moved. The reference’s own error is drawn grey: to the left of it nothing can be told apart.</source>
        <translation>Desde los mismos momentos, la escena avanza con muchos ajustes. Cada uno es un punto: cuánto calcula y a qué distancia queda de una referencia refinada hasta que apenas se movió. El error propio de la referencia se dibuja en gris: a su izquierda no se puede distinguir nada.</translation>
    </message>
    <message>
        <source>There is no comparison with %1: %2</source>
        <translation>No hay comparación con %1: %2</translation>
    </message>
    <message>
        <source>Computing time over the error of %1, against %2.</source>
        <translation>Tiempo de cálculo según el error de %1, frente a %2.</translation>
    </message>
</context>
<context>
    <name>glenoid::ReportStability</name>
    <message>
        <source>Cases of the gauntlet, with the worst figures of their trials. Energy: gained beyond what there was and what was put in. Recovery: from the end of the load to rest.</source>
        <translation>Casos difíciles, con las peores cifras de sus pruebas. Energía: la ganada de más sobre la que había y la que se aportó. Recuperación: desde el fin de la carga hasta el reposo.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Caso</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Resistió</translation>
    </message>
    <message>
        <source>Energy, %</source>
        <translation>Energía, %</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Profundidad, mm</translation>
    </message>
    <message>
        <source>Of its bound</source>
        <translation>De su límite</translation>
    </message>
    <message>
        <source>Recovery, s</source>
        <translation>Recuperación, s</translation>
    </message>
    <message>
        <source>Inside out at the end</source>
        <translation>Vueltos del revés al final</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>What stays stable: %1</source>
        <translation>Lo que sigue estable: %1</translation>
    </message>
    <message>
        <source>What did not hold</source>
        <translation>Lo que no resistió</translation>
    </message>
    <message>
        <source>, as published</source>
        <translation>, como se publicó</translation>
    </message>
    <message>
        <source>The end of %1.</source>
        <translation>El final de %1.</translation>
    </message>
</context>
<context>
    <name>glenoid::SceneView</name>
    <message>
        <source>3D view of the joint</source>
        <translation>Vista 3D de la articulación</translation>
    </message>
</context>
<context>
    <name>glenoid::Sentences</name>
    <message>
        <source>There is no such file or folder.</source>
        <translation>No existe ese archivo o carpeta.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>El archivo no se puede leer.</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>El archivo no se puede escribir.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>El archivo está vacío.</translation>
    </message>
    <message>
        <source>The file ends before its own header says it should.</source>
        <translation>El archivo termina antes de lo que dice su propia cabecera.</translation>
    </message>
    <message>
        <source>The file is too large: %1, where at most %2 is accepted.</source>
        <translation>El archivo es demasiado grande: %1, cuando se acepta como máximo %2.</translation>
    </message>
    <message>
        <source>The text is not valid JSON: line %1, column %2.</source>
        <translation>El texto no es JSON válido: línea %1, columna %2.</translation>
    </message>
    <message>
        <source>The text is nested more deeply than any sensible file.</source>
        <translation>El texto está anidado más profundamente que cualquier archivo razonable.</translation>
    </message>
    <message>
        <source>The file was written by a newer version: it says schema %1, this program knows up to %2.</source>
        <translation>El archivo lo escribió una versión más nueva: indica el esquema %1 y este programa conoce hasta el %2.</translation>
    </message>
    <message>
        <source>The content does not have the expected form: %1.</source>
        <translation>El contenido no tiene la forma esperada: %1.</translation>
    </message>
    <message>
        <source>A number is not finite.</source>
        <translation>Un número no es finito.</translation>
    </message>
    <message>
        <source>The value %1 is outside the range from %2 to %3.</source>
        <translation>El valor %1 está fuera del intervalo de %2 a %3.</translation>
    </message>
    <message>
        <source>“%1” is referred to as %2, but nothing has that name.</source>
        <translation>Se hace referencia a «%1» como %2, pero nada tiene ese nombre.</translation>
    </message>
    <message>
        <source>The name “%1” is used twice.</source>
        <translation>El nombre «%1» se usa dos veces.</translation>
    </message>
    <message>
        <source>“%1” refers back to itself.</source>
        <translation>«%1» se refiere a sí mismo.</translation>
    </message>
    <message>
        <source>A reference leaves its folder or points at the wrong kind of thing.</source>
        <translation>Una referencia sale de su carpeta o apunta a algo de otro tipo.</translation>
    </message>
    <message>
        <source>The mesh cannot be used: %1.</source>
        <translation>La malla no se puede usar: %1.</translation>
    </message>
    <message>
        <source>A tetrahedron has no positive volume (%1).</source>
        <translation>Un tetraedro no tiene volumen positivo (%1).</translation>
    </message>
    <message>
        <source>The surface is not closed: open edges: %1.</source>
        <translation>La superficie no está cerrada: aristas abiertas: %1.</translation>
    </message>
    <message>
        <source>Index %1 is outside a list of %2 entries.</source>
        <translation>El índice %1 está fuera de una lista de %2 elementos.</translation>
    </message>
    <message>
        <source>The content is not what its name promises; the file was changed or damaged.</source>
        <translation>El contenido no es el que promete su nombre; el archivo se cambió o se dañó.</translation>
    </message>
    <message>
        <source>The format of the file is not known.</source>
        <translation>El formato del archivo es desconocido.</translation>
    </message>
    <message>
        <source>The region of the coupling cannot hold against turning: %1 mm² with radii of gyration of %2 and %3 mm.</source>
        <translation>La región del acoplamiento no puede sujetar contra el giro: %1 mm² con radios de giro de %2 y %3 mm.</translation>
    </message>
    <message>
        <source>The scene cannot be simulated: %1.</source>
        <translation>La escena no se puede simular: %1.</translation>
    </message>
    <message>
        <source>The command cannot be understood: %1.</source>
        <translation>No se entiende la orden: %1.</translation>
    </message>
    <message>
        <source>No OpenGL 3.3 context could be made, so nothing can be drawn in 3D.</source>
        <translation>No se pudo crear un contexto de OpenGL 3.3, así que no se puede dibujar nada en 3D.</translation>
    </message>
    <message>
        <source>The work was stopped as you asked; nothing was changed.</source>
        <translation>El trabajo se detuvo como pidió; no se cambió nada.</translation>
    </message>
    <message>
        <source>It took longer than %1 s and was stopped.</source>
        <translation>Tardó más de %1 s y se detuvo.</translation>
    </message>
    <message>
        <source>It needed more memory than %1 and was stopped.</source>
        <translation>Necesitó más memoria que %1 y se detuvo.</translation>
    </message>
    <message>
        <source>Reading the file made its reader break down; nothing else was harmed.</source>
        <translation>Al leer el archivo falló su lector; nada más resultó dañado.</translation>
    </message>
    <message>
        <source>A check did not hold: %1.</source>
        <translation>Una comprobación no se cumplió: %1.</translation>
    </message>
    <message>
        <source>Something went wrong inside the program; this is an error of ours.</source>
        <translation>Algo falló dentro del programa; es un error nuestro.</translation>
    </message>
    <message>
        <source>Check the path and the spelling.</source>
        <translation>Compruebe la ruta y la ortografía.</translation>
    </message>
    <message>
        <source>Check that it is a file and that you are allowed to read it.</source>
        <translation>Compruebe que es un archivo y que tiene permiso para leerlo.</translation>
    </message>
    <message>
        <source>Check that the folder exists, that you may write there and that the disk has room.</source>
        <translation>Compruebe que la carpeta existe, que puede escribir en ella y que hay espacio en el disco.</translation>
    </message>
    <message>
        <source>Save or copy it again.</source>
        <translation>Guárdelo o cópielo de nuevo.</translation>
    </message>
    <message>
        <source>Copy or download it again; the first try stopped half way.</source>
        <translation>Cópielo o descárguelo de nuevo; el primer intento se quedó a medias.</translation>
    </message>
    <message>
        <source>Simplify the mesh before you bring it in.</source>
        <translation>Simplifique la malla antes de traerla.</translation>
    </message>
    <message>
        <source>Correct the text at that place.</source>
        <translation>Corrija el texto en ese lugar.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Compruebe que es el archivo que quería.</translation>
    </message>
    <message>
        <source>Update Glenoid Studio to open it.</source>
        <translation>Actualice Glenoid Studio para abrirlo.</translation>
    </message>
    <message>
        <source>Correct that entry; the schemas that ship with the program describe the form.</source>
        <translation>Corrija esa entrada; los esquemas incluidos con el programa describen la forma.</translation>
    </message>
    <message>
        <source>Replace it by an ordinary number.</source>
        <translation>Sustitúyalo por un número corriente.</translation>
    </message>
    <message>
        <source>Choose a value inside the range.</source>
        <translation>Elija un valor dentro del intervalo.</translation>
    </message>
    <message>
        <source>Correct the name, or add what is missing.</source>
        <translation>Corrija el nombre o añada lo que falta.</translation>
    </message>
    <message>
        <source>Give one of the two another name.</source>
        <translation>Dé otro nombre a uno de los dos.</translation>
    </message>
    <message>
        <source>Remove one of the references of the circle.</source>
        <translation>Quite una de las referencias del círculo.</translation>
    </message>
    <message>
        <source>Refer to something of the right kind inside the folder.</source>
        <translation>Haga referencia a algo del tipo correcto dentro de la carpeta.</translation>
    </message>
    <message>
        <source>Repair the mesh in the program that made it and bring it in again.</source>
        <translation>Repare la malla en el programa que la creó y tráigala de nuevo.</translation>
    </message>
    <message>
        <source>Build the volume again, or choose another cell size.</source>
        <translation>Construya el volumen de nuevo o elija otro tamaño de celda.</translation>
    </message>
    <message>
        <source>Close the holes, so that inside and outside can be told apart.</source>
        <translation>Cierre los agujeros para que se distinga el interior del exterior.</translation>
    </message>
    <message>
        <source>The file was cut or edited; write it again from its source.</source>
        <translation>El archivo se cortó o se editó; escríbalo de nuevo desde su origen.</translation>
    </message>
    <message>
        <source>Restore the original file, or save the joint again.</source>
        <translation>Restaure el archivo original o guarde de nuevo la articulación.</translation>
    </message>
    <message>
        <source>Enlarge the region of the coupling.</source>
        <translation>Amplíe la región del acoplamiento.</translation>
    </message>
    <message>
        <source>Couplings find nothing to hold: %1.</source>
        <translation>Hay acoplamientos que no encuentran nada que sujetar: %1.</translation>
    </message>
    <message>
        <source>Enlarge “within”, or check unit and place of both parts.</source>
        <translation>Aumente «within» o compruebe la unidad y la posición de ambas partes.</translation>
    </message>
    <message>
        <source>Change the part or the setting that is named.</source>
        <translation>Cambie la parte o el ajuste que se nombra.</translation>
    </message>
    <message>
        <source>“glenoid --help” lists what can be said.</source>
        <translation>«glenoid --help» enumera lo que se puede pedir.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or use the command line, which needs no display.</source>
        <translation>Actualice el controlador gráfico o use la línea de órdenes, que no necesita pantalla.</translation>
    </message>
    <message>
        <source>Start it again whenever you like.</source>
        <translation>Puede volver a empezarlo cuando quiera.</translation>
    </message>
    <message>
        <source>Use a smaller file, or allow more time.</source>
        <translation>Use un archivo más pequeño o permita más tiempo.</translation>
    </message>
    <message>
        <source>Use a smaller file, or allow more memory.</source>
        <translation>Use un archivo más pequeño o permita más memoria.</translation>
    </message>
    <message>
        <source>The file is damaged: write it again in the program that made it, or in another format.</source>
        <translation>El archivo está dañado: guárdelo de nuevo en el programa que lo hizo o en otro formato.</translation>
    </message>
    <message>
        <source>Look at the report for the figures behind it.</source>
        <translation>Consulte en el informe las cifras correspondientes.</translation>
    </message>
    <message>
        <source>Please report it with the log, and save your work under another name.</source>
        <translation>Comuníquelo junto con el registro y guarde su trabajo con otro nombre.</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>en %1</translation>
    </message>
    <message>
        <source>in “%1”</source>
        <translation>en «%1»</translation>
    </message>
    <message>
        <source>element %1</source>
        <translation>elemento %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>switched on by the scenario</source>
        <translation>activado por el escenario</translation>
    </message>
    <message>
        <source>switched off by the scenario</source>
        <translation>desactivado por el escenario</translation>
    </message>
    <message>
        <source>the scene holds something it acts on</source>
        <translation>la escena contiene algo sobre lo que actúa</translation>
    </message>
    <message>
        <source>nothing in the scene for it to act on</source>
        <translation>no hay nada en la escena sobre lo que actúe</translation>
    </message>
    <message>
        <source>not available in this version</source>
        <translation>no disponible en esta versión</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Couplings</source>
        <translation>Acoplamientos</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Self-contact</source>
        <translation>Autocontacto</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Rozamiento</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguamiento</translation>
    </message>
    <message>
        <source>Haptics</source>
        <translation>Háptica</translation>
    </message>
    <message>
        <source>Bursa</source>
        <translation>Bolsa sinovial</translation>
    </message>
    <message>
        <source>Skin layer</source>
        <translation>Capa de piel</translation>
    </message>
    <message>
        <source>Dents under a tip</source>
        <translation>Hundimiento bajo una punta</translation>
    </message>
    <message>
        <source>Use a .joint folder, a .jointz file, a .scenario.json, or a surface as OBJ, STL, PLY, glTF, GLB, 3MF, DAE, FBX, VTP, VTU or VTK.</source>
        <translation>Use una carpeta .joint, un archivo .jointz, un .scenario.json o una superficie en OBJ, STL, PLY, glTF, GLB, 3MF, DAE, FBX, VTP, VTU o VTK.</translation>
    </message>
    <message>
        <source>The coupling names neither a region nor nodes to hold at. Give it one of the two.</source>
        <translation>El acoplamiento no nombra ni una región ni nodos en los que sujetar. Dele una de las dos cosas.</translation>
    </message>
    <message>
        <source>The coupling names a region and nodes, and holds by one of the two. Take the other out.</source>
        <translation>El acoplamiento nombra una región y nodos, y sujeta por una de las dos cosas. Quite la otra.</translation>
    </message>
    <message>
        <source>The stiffness of a coupling at nodes is stiffnessPerNode, that of one over a region stiffnessPerArea. Take the other out.</source>
        <translation>La rigidez de un acoplamiento en nodos es stiffnessPerNode, la de uno sobre una región stiffnessPerArea. Quite la otra.</translation>
    </message>
    <message>
        <source>The coupling names nodes of “%1”, which is rigid and has none. Name a region of it instead, or make the soft part its part A.</source>
        <translation>El acoplamiento nombra nodos de «%1», que es rígida y no tiene. Nombre en su lugar una región suya, o haga de la pieza blanda su parte A.</translation>
    </message>
    <message>
        <source>The coupling names node %1, where the last one of its part’s cells is %2. Pick its nodes again.</source>
        <translation>El acoplamiento nombra el nodo %1, y el último de las celdas de su pieza es el %2. Elija de nuevo sus nodos.</translation>
    </message>
    <message>
        <source>The coupling names node %1 twice. Take one of them out.</source>
        <translation>El acoplamiento nombra dos veces el nodo %1. Quite uno.</translation>
    </message>
    <message>
        <source>The coupling cannot hold against turning: nodes picked: %1. Pick three or more that do not lie in a line.</source>
        <translation>El acoplamiento no puede impedir el giro: nodos elegidos: %1. Elija tres o más que no estén en una línea.</translation>
    </message>
    <message>
        <source>The coupling cannot hold against turning: its nodes lie in a line (number: %1). Pick another one beside it.</source>
        <translation>El acoplamiento no puede impedir el giro: sus nodos están en una línea (número: %1). Elija otro al lado.</translation>
    </message>
    <message>
        <source>Of the nodes that hold the coupling, %1 have no node of the new cells within half the diagonal of a cell (the farthest: %2 mm). Make other cells, or remove the coupling and pick its nodes on the new cells.</source>
        <translation>De los nodos que sujetan el acoplamiento, %1 no tienen ningún nodo de las celdas nuevas a media diagonal de una celda (el más lejano: %2 mm). Haga otras celdas, o quite el acoplamiento y elija sus nodos en las celdas nuevas.</translation>
    </message>
    <message>
        <source>The nodes of the coupling cannot be used: %1. Pick them again.</source>
        <translation>Los nodos del acoplamiento no se pueden usar: %1. Elíjalos de nuevo.</translation>
    </message>
</context>
<context>
    <name>glenoid::SettingPictures</name>
    <message>
        <source>The picture of a setting could not be drawn.</source>
        <translation>No se pudo dibujar la imagen de un ajuste.</translation>
    </message>
    <message>
        <source>The picture of a setting could not be drawn: %1 cannot be run.</source>
        <translation>No se pudo dibujar la imagen de un ajuste: no se puede ejecutar %1.</translation>
    </message>
</context>
<context>
    <name>glenoid::SettingWords</name>
    <message>
        <source>solved as published</source>
        <translation>resuelto como se publicó</translation>
    </message>
    <message>
        <source>solved by the reference</source>
        <translation>resuelto por la referencia</translation>
    </message>
    <message>
        <source>solved directly</source>
        <translation>resuelto directamente</translation>
    </message>
    <message>
        <source>whole cells for elements</source>
        <translation>celdas enteras como elementos</translation>
    </message>
    <message>
        <source>tetrahedra for elements</source>
        <translation>tetraedros como elementos</translation>
    </message>
    <message>
        <source>elements as each part has them</source>
        <translation>elementos según cada pieza</translation>
    </message>
    <message>
        <source>with all of our additions</source>
        <translation>con todos nuestros añadidos</translation>
    </message>
    <message>
        <source>with stiffness of what is under tension</source>
        <translation>con la rigidez de lo que está en tensión</translation>
    </message>
    <message>
        <source>with its recovery speed capped</source>
        <translation>con la velocidad de recuperación limitada</translation>
    </message>
    <message>
        <source>with steps cut in parts</source>
        <translation>con pasos partidos</translation>
    </message>
    <message>
        <source>with a second search</source>
        <translation>con una segunda búsqueda</translation>
    </message>
    <message>
        <source>with the law of far stretched tissue</source>
        <translation>con la ley del tejido muy estirado</translation>
    </message>
    <message>
        <source>twice as many tetrahedra</source>
        <translation>el doble de tetraedros</translation>
    </message>
    <message>
        <source>%1 times as many tetrahedra</source>
        <translation>%1 veces más tetraedros</translation>
    </message>
    <message>
        <source>the visual surfaces touch</source>
        <translation>se tocan las superficies visuales</translation>
    </message>
    <message>
        <source>steps of %1 ms</source>
        <translation>pasos de %1 ms</translation>
    </message>
    <message>
        <source>contact from %1 mm on</source>
        <translation>contacto desde %1 mm</translation>
    </message>
    <message>
        <source>recovery at %1 mm/s at most</source>
        <translation>recuperación a %1 mm/s como mucho</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>conjugate gradients to %1</source>
        <translation>gradientes conjugados hasta %1</translation>
    </message>
    <message>
        <source>%1 outer iterations at most</source>
        <translation>%1 iteraciones externas como mucho</translation>
    </message>
    <message>
        <source>outer iterations to %1</source>
        <translation>iteraciones externas hasta %1</translation>
    </message>
    <message>
        <source>the splitting holds whole parts</source>
        <translation>la separación abarca piezas enteras</translation>
    </message>
    <message>
        <source>λmax up to %1</source>
        <translation>λmax hasta %1</translation>
    </message>
    <message>
        <source>%1 inner sweeps</source>
        <translation>%1 barridos internos</translation>
    </message>
    <message>
        <source>could not be built: %1</source>
        <translation>no se pudo construir: %1</translation>
    </message>
    <message>
        <source>%1 of %2 steps were not finite</source>
        <translation>%1 de %2 pasos no fueron finitos</translation>
    </message>
    <message>
        <source>%1 of %2 steps diverged</source>
        <translation>%1 de %2 pasos divergieron</translation>
    </message>
    <message>
        <source>displacement</source>
        <translation>desplazamiento</translation>
    </message>
    <message>
        <source>contact force</source>
        <translation>fuerza de contacto</translation>
    </message>
    <message>
        <source>penetration</source>
        <translation>penetración</translation>
    </message>
    <message>
        <source>force on the hand</source>
        <translation>fuerza en la mano</translation>
    </message>
    <message>
        <source>the same cells, very small steps</source>
        <translation>las mismas celdas, pasos muy pequeños</translation>
    </message>
    <message>
        <source>finer cells, smaller steps</source>
        <translation>celdas más finas, pasos menores</translation>
    </message>
    <message>
        <source>the scene</source>
        <translation>la escena</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>paso de tiempo</translation>
    </message>
    <message>
        <source>solver</source>
        <translation>resolución</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>elementos</translation>
    </message>
    <message>
        <source>cell size</source>
        <translation>tamaño de celda</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>superficies</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contacto</translation>
    </message>
    <message>
        <source>published method</source>
        <translation>método publicado</translation>
    </message>
    <message>
        <source>%1 in place of %2</source>
        <translation>%1 en lugar de %2</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 tetrahedra</source>
        <translation>%1 tetraedros</translation>
    </message>
    <message>
        <source>the simplified surfaces touch again</source>
        <translation>vuelven a tocarse las superficies simplificadas</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>the scene as it is</source>
        <translation>la escena tal como está</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>glenoid::StabilityEntries</name>
    <message>
        <source>Left alone</source>
        <translation>Sin tocar</translation>
    </message>
    <message>
        <source>A tool presses</source>
        <translation>Una herramienta aprieta</translation>
    </message>
    <message>
        <source>The hand is suddenly inside</source>
        <translation>La mano está de pronto dentro</translation>
    </message>
    <message>
        <source>Impact</source>
        <translation>Impacto</translation>
    </message>
    <message>
        <source>Fast drag</source>
        <translation>Arrastre rápido</translation>
    </message>
    <message>
        <source>Squeezed by a strong hand</source>
        <translation>Apretado por una mano fuerte</translation>
    </message>
    <message>
        <source>The device falls silent</source>
        <translation>El dispositivo enmudece</translation>
    </message>
    <message>
        <source>The device goes wild</source>
        <translation>El dispositivo enloquece</translation>
    </message>
    <message>
        <source>A blow on a bone</source>
        <translation>Un golpe en un hueso</translation>
    </message>
    <message>
        <source>End of range</source>
        <translation>Fin del recorrido</translation>
    </message>
    <message>
        <source>Start at speed</source>
        <translation>Salida a velocidad</translation>
    </message>
    <message>
        <source>Random loads</source>
        <translation>Cargas al azar</translation>
    </message>
    <message>
        <source>Gravity turned</source>
        <translation>Gravedad girada</translation>
    </message>
    <message>
        <source>Gravity gone</source>
        <translation>Sin gravedad</translation>
    </message>
    <message>
        <source>Nodes scattered</source>
        <translation>Nodos dispersos</translation>
    </message>
    <message>
        <source>Collapsed to a plane</source>
        <translation>Aplastado en un plano</translation>
    </message>
    <message>
        <source>Collapsed to a point</source>
        <translation>Aplastado en un punto</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Reflejado</translation>
    </message>
    <message>
        <source>Turned inside out</source>
        <translation>Vuelto del revés</translation>
    </message>
    <message>
        <source>Flattened</source>
        <translation>Achatado</translation>
    </message>
    <message>
        <source>A thousand times stiffer</source>
        <translation>Mil veces más rígido</translation>
    </message>
    <message>
        <source>A thousand times softer</source>
        <translation>Mil veces más blando</translation>
    </message>
    <message>
        <source>Poisson’s ratio 0.49</source>
        <translation>Coeficiente de Poisson 0,49</translation>
    </message>
    <message>
        <source>Poisson’s ratio 0.4999</source>
        <translation>Coeficiente de Poisson 0,4999</translation>
    </message>
    <message>
        <source>not finite</source>
        <translation>no finito</translation>
    </message>
    <message>
        <source>steps not taken</source>
        <translation>pasos no dados</translation>
    </message>
    <message>
        <source>energy gained</source>
        <translation>ganó energía</translation>
    </message>
    <message>
        <source>too deep</source>
        <translation>demasiado hondo</translation>
    </message>
    <message>
        <source>left inside out</source>
        <translation>quedó del revés</translation>
    </message>
    <message>
        <source>too deep at the end</source>
        <translation>demasiado hondo al final</translation>
    </message>
    <message>
        <source>does not come to rest</source>
        <translation>no llega al reposo</translation>
    </message>
    <message>
        <source>took too long</source>
        <translation>tardó demasiado</translation>
    </message>
    <message>
        <source>After %1 steps the state is not finite.</source>
        <translation>Tras %1 pasos el estado no es finito.</translation>
    </message>
    <message>
        <source>%1 of %2 steps were not finite and not taken.</source>
        <translation>%1 de %2 pasos no fueron finitos y no se dieron.</translation>
    </message>
    <message>
        <source>It holds %1 % more energy than what it had and what was done to it.</source>
        <translation>Tiene un %1 % más de energía de la que tenía y se le aportó.</translation>
    </message>
    <message>
        <source>%1 lie %2 mm in each other, %3 times as deep as they may.</source>
        <translation>%1 se hunden %2 mm uno en otro, %3 veces lo permitido.</translation>
    </message>
    <message>
        <source>%1 elements are still inside out.</source>
        <translation>%1 elementos siguen del revés.</translation>
    </message>
    <message>
        <source>At the end surfaces still lie too deep in each other.</source>
        <translation>Al final las superficies siguen demasiado hundidas una en otra.</translation>
    </message>
    <message>
        <source>%1 s after the load it was not at rest; at the end its fastest point moves at %2 mm/s.</source>
        <translation>%1 s después de la carga no estaba en reposo; al final su punto más rápido va a %2 mm/s.</translation>
    </message>
    <message>
        <source>It took too long and was stopped after %1 s of simulated time.</source>
        <translation>Tardó demasiado y se paró tras %1 s de tiempo simulado.</translation>
    </message>
    <message>
        <source>held</source>
        <translation>resistió</translation>
    </message>
    <message>
        <source>held; cannot carry itself</source>
        <translation>resistió; no se sostiene</translation>
    </message>
    <message>
        <source>It held.</source>
        <translation>Resistió.</translation>
    </message>
    <message>
        <source>Its matter cannot carry its weight and its loads: it need not come to rest.</source>
        <translation>Su materia no puede sostener su peso y sus cargas: no tiene que llegar al reposo.</translation>
    </message>
    <message>
        <source>%1 of %2 trials held.</source>
        <translation>Resistieron %1 de %2 pruebas.</translation>
    </message>
    <message>
        <source>Of the published method, which does not count: %1 of %2.</source>
        <translation>Del método publicado, que no cuenta: %1 de %2.</translation>
    </message>
</context>
<context>
    <name>glenoid::StabilityPanel</name>
    <message>
        <source> (as published)</source>
        <translation> (como se publicó)</translation>
    </message>
    <message>
        <source>There is a picture</source>
        <translation>Hay una imagen</translation>
    </message>
    <message>
        <source>How %1 ended</source>
        <translation>Cómo acabó %1</translation>
    </message>
    <message>
        <source>The view shows %1 again, step for step.</source>
        <translation>La vista muestra otra vez %1, paso a paso.</translation>
    </message>
    <message>
        <source>%1 has ended as in the study, bit for bit.</source>
        <translation>%1 ha acabado como en el estudio, bit a bit.</translation>
    </message>
    <message>
        <source>%1 has ended otherwise than in the study: another build, or another processor.</source>
        <translation>%1 ha acabado de otro modo que en el estudio: otra compilación u otro procesador.</translation>
    </message>
    <message>
        <source>%1 has ended.</source>
        <translation>%1 ha acabado.</translation>
    </message>
    <message>
        <source>This trial held, so no recording of it was kept.</source>
        <translation>Esta prueba resistió, así que no se guardó su grabación.</translation>
    </message>
    <message>
        <source>Prepare the trial</source>
        <translation>Preparar la prueba</translation>
    </message>
    <message>
        <source>Filter by trial, part or verdict</source>
        <translation>Filtrar por prueba, pieza o veredicto</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtro</translation>
    </message>
    <message>
        <source>Only &amp;failures</source>
        <translation>Solo &amp;fallos</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Prueba</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sobre</translation>
    </message>
    <message>
        <source>Δt, ms</source>
        <translation>Δt, ms</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Energy, %</source>
        <translation>Energía, %</translation>
    </message>
    <message>
        <source>Depth, mm</source>
        <translation>Profundidad, mm</translation>
    </message>
    <message>
        <source>Recovery, s</source>
        <translation>Recuperación, s</translation>
    </message>
    <message>
        <source>Inside out</source>
        <translation>Del revés</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>What is done to the scene</source>
        <translation>Qué se le hace a la escena</translation>
    </message>
    <message>
        <source>To what it is done</source>
        <translation>A qué se le hace</translation>
    </message>
    <message>
        <source>Time step of the trial</source>
        <translation>Paso de tiempo de la prueba</translation>
    </message>
    <message>
        <source>Whether it held, or which bounds it broke</source>
        <translation>Si resistió, o qué límites rompió</translation>
    </message>
    <message>
        <source>Energy beyond what there was and what was put in</source>
        <translation>Energía de más sobre la que había y la que se aportó</translation>
    </message>
    <message>
        <source>How deep surfaces lay in each other at most</source>
        <translation>Cuánto se hundieron como mucho unas superficies en otras</translation>
    </message>
    <message>
        <source>From the end of the load until it was at rest</source>
        <translation>Desde el fin de la carga hasta el reposo</translation>
    </message>
    <message>
        <source>Elements inside out: most at once, and at the end</source>
        <translation>Elementos del revés: el máximo a la vez, y al final</translation>
    </message>
    <message>
        <source>A failure has a picture of its end</source>
        <translation>Un fallo tiene una imagen de su final</translation>
    </message>
    <message>
        <source>Trials of the gauntlet</source>
        <translation>Pruebas difíciles</translation>
    </message>
    <message>
        <source>&amp;Run it again in the view</source>
        <translation>&amp;Repetirla en la vista</translation>
    </message>
    <message>
        <source>Show the failure as it went, step for step; a double click on its row does the same</source>
        <translation>Mostrar el fallo tal como fue, paso a paso; un doble clic en su fila hace lo mismo</translation>
    </message>
    <message>
        <source>&amp;Back to the scene</source>
        <translation>&amp;Volver a la escena</translation>
    </message>
</context>
<context>
    <name>glenoid::StageBars</name>
    <message>
        <source>Whole step</source>
        <translation>Paso entero</translation>
    </message>
    <message>
        <source>Thread time of a step, ms: median, whisker up to 95 of 100</source>
        <translation>Tiempo de hilo por paso, ms: mediana, bigote hasta 95 de 100</translation>
    </message>
    <message>
        <source>Time of a step by stage</source>
        <translation>Tiempo de un paso por etapas</translation>
    </message>
    <message>
        <source>budget: %1</source>
        <translation>presupuesto: %1</translation>
    </message>
    <message>
        <source>budget: %1, to the right of this →</source>
        <translation>presupuesto: %1, más a la derecha →</translation>
    </message>
</context>
<context>
    <name>glenoid::StatusFigures</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 % of real time</source>
        <translation>%1 % del tiempo real</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>en pausa</translation>
    </message>
    <message>
        <source>%1 steps/s</source>
        <translation>%1 pasos/s</translation>
    </message>
    <message>
        <source>%1 ms/step</source>
        <translation>%1 ms/paso</translation>
    </message>
    <message numerus="yes">
        <source>%n contact(s)</source>
        <translation>
            <numerusform>%n contacto</numerusform>
            <numerusform>%n contactos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n island(s)</source>
        <translation>
            <numerusform>%n isla</numerusform>
            <numerusform>%n islas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Tiempo simulado</translation>
    </message>
    <message>
        <source>How fast the simulation runs against the clock; below 100 % it is too slow for this computer</source>
        <translation>Velocidad de la simulación respecto al reloj; por debajo del 100 % es demasiado lenta para este equipo</translation>
    </message>
    <message>
        <source>Simulation steps in one second</source>
        <translation>Pasos de simulación en un segundo</translation>
    </message>
    <message>
        <source>Time that one step takes, mean of the last half second</source>
        <translation>Tiempo que tarda un paso, media del último medio segundo</translation>
    </message>
    <message>
        <source>Contacts of the last step, of which %1 press</source>
        <translation>Contactos del último paso, de los cuales %1 hacen presión</translation>
    </message>
    <message>
        <source>Groups of parts that touch each other</source>
        <translation>Grupos de partes que se tocan entre sí</translation>
    </message>
    <message>
        <source>Pictures drawn in the last second; none are drawn while nothing changes</source>
        <translation>Imágenes dibujadas en el último segundo; no se dibuja ninguna mientras nada cambia</translation>
    </message>
</context>
<context>
    <name>glenoid::StudiedScene</name>
    <message>
        <source>The joint was edited since it was studied, and this setting would put other cells or surfaces in its place. Study it again first.</source>
        <translation>La articulación se editó después de estudiarla, y este ajuste pondría otras celdas o superficies en su lugar. Estúdiela de nuevo antes.</translation>
    </message>
    <message>
        <source>Use the setting: %1</source>
        <translation>Usar el ajuste: %1</translation>
    </message>
</context>
<context>
    <name>glenoid::StudyBar</name>
    <message>
        <source>Stopped. What was found until then stays in its folder.</source>
        <translation>Detenido. Lo hallado hasta entonces queda en su carpeta.</translation>
    </message>
    <message>
        <source>There is no study in %1.</source>
        <translation>No hay ningún estudio en %1.</translation>
    </message>
    <message>
        <source>The study in %1 is of another kind.</source>
        <translation>El estudio de %1 es de otro tipo.</translation>
    </message>
    <message>
        <source>This study was stopped before its end.</source>
        <translation>Este estudio se detuvo antes de acabar.</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Abrir un estudio</translation>
    </message>
    <message>
        <source>%1 % done</source>
        <translation>%1 % hecho</translation>
    </message>
    <message numerus="yes">
        <source>%1 % done, about %n second(s) left</source>
        <translation>
            <numerusform>%1 % hecho, queda alrededor de %n segundo</numerusform>
            <numerusform>%1 % hecho, quedan alrededor de %n segundos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 % done, about %n minute(s) left</source>
        <translation>
            <numerusform>%1 % hecho, queda alrededor de %n minuto</numerusform>
            <numerusform>%1 % hecho, quedan alrededor de %n minutos</numerusform>
        </translation>
    </message>
    <message>
        <source>looking for moments to compare</source>
        <translation>buscando momentos que comparar</translation>
    </message>
    <message>
        <source>taking times</source>
        <translation>midiendo tiempos</translation>
    </message>
    <message>
        <source>checking the reference</source>
        <translation>comprobando la referencia</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>En %1</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Rápido</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Completo</translation>
    </message>
    <message>
        <source>How thorough the study is</source>
        <translation>Lo completo que es el estudio</translation>
    </message>
    <message>
        <source>Quick: a few minutes at most. Whole: up to twenty.</source>
        <translation>Rápido: unos minutos como mucho. Completo: hasta veinte.</translation>
    </message>
    <message>
        <source>&amp;Run the study</source>
        <translation>&amp;Hacer el estudio</translation>
    </message>
    <message>
        <source>Study the scene as it stands now, in a process of its own</source>
        <translation>Estudiar la escena tal como está ahora, en un proceso propio</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Parar</translation>
    </message>
    <message>
        <source>&amp;Open a study…</source>
        <translation>A&amp;brir un estudio…</translation>
    </message>
    <message>
        <source>Show a study of before from its folder</source>
        <translation>Mostrar un estudio anterior desde su carpeta</translation>
    </message>
    <message>
        <source>How far the study is</source>
        <translation>Cuánto lleva el estudio</translation>
    </message>
</context>
<context>
    <name>glenoid::StudyProcess</name>
    <message>
        <source>The study could not be started: %1 cannot be run.</source>
        <translation>No se pudo empezar el estudio: no se puede ejecutar %1.</translation>
    </message>
    <message>
        <source>The study broke off: its process ended by itself. What it had found is kept in %1.</source>
        <translation>El estudio se interrumpió: su proceso acabó por sí solo. Lo que había hallado se conserva en %1.</translation>
    </message>
    <message>
        <source>The study ended with the exit status %1 and did not say why.</source>
        <translation>El estudio acabó con el estado de salida %1 y no dijo por qué.</translation>
    </message>
</context>
<context>
    <name>glenoid::StudyReport</name>
    <message>
        <source>What accuracy costs</source>
        <translation>Lo que cuesta la exactitud</translation>
    </message>
    <message>
        <source>What stays stable</source>
        <translation>Lo que sigue estable</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Verdad</translation>
    </message>
    <message>
        <source>What each effect costs</source>
        <translation>Lo que cuesta cada efecto</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>The studies, and the machine and build that their times are of.</source>
        <translation>Los estudios, y la máquina y la compilación de las que son sus tiempos.</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Estudio</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Procesador</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Compilación</translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation>Núcleos de cálculo</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Hilos</translation>
    </message>
    <message>
        <source>quick</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>completo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Further columns are in the file %1.csv.</source>
        <translation>Las demás columnas están en el archivo %1.csv.</translation>
    </message>
    <message>
        <source>Studies of %1</source>
        <translation>Estudios de %1</translation>
    </message>
    <message>
        <source>Written on %1.</source>
        <translation>Escrito el %1.</translation>
    </message>
    <message>
        <source>In short</source>
        <translation>En resumen</translation>
    </message>
    <message>
        <source>Hard cases of %1: %2</source>
        <translation>Casos difíciles de %1: %2</translation>
    </message>
    <message>
        <source>The study of %1 in %2 did not come to its end; what it had found until then is shown.</source>
        <translation>El estudio de %1 en %2 no llegó a su fin; se muestra lo que había hallado hasta entonces.</translation>
    </message>
    <message>
        <source>Times are thread CPU time of one thread. Another machine has others; errors are a function of scene, build and kernels alone.</source>
        <translation>Los tiempos son tiempo de CPU de un hilo. Otra máquina tiene otros; los errores dependen solo de la escena, la compilación y los núcleos de cálculo.</translation>
    </message>
</context>
<context>
    <name>glenoid::TasksPanel</name>
    <message numerus="yes">
        <source>%n error(s)</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errores</numerusform>
        </translation>
    </message>
    <message>
        <source>This scene has no tasks.</source>
        <translation>Esta escena no tiene tareas.</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>&amp;Pista</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>&amp;Otra vez</translation>
    </message>
    <message>
        <source>What was measured</source>
        <translation>Qué se midió</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 de %2 puntos</translation>
    </message>
    <message>
        <source>%1 deviations from others</source>
        <translation>a %1 desviaciones de los demás</translation>
    </message>
    <message>
        <source>kept (at most %1)</source>
        <translation>cumplido (como mucho %1)</translation>
    </message>
    <message>
        <source>not kept (at most %1)</source>
        <translation>no cumplido (como mucho %1)</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>to keep the run for you</source>
        <translation>para guardar el ejercicio</translation>
    </message>
    <message>
        <source>My &amp;runs…</source>
        <translation>&amp;Mis ejercicios…</translation>
    </message>
</context>
<context>
    <name>glenoid::TimesPlot</name>
    <message>
        <source>half of the steps stay below</source>
        <translation>la mitad de los pasos queda debajo</translation>
    </message>
    <message>
        <source>95 of 100 stay below</source>
        <translation>95 de cada 100 quedan debajo</translation>
    </message>
    <message>
        <source>ms a step</source>
        <translation>ms por paso</translation>
    </message>
    <message>
        <source>Time of a step over the last two minutes</source>
        <translation>Tiempo por paso en los últimos dos minutos</translation>
    </message>
    <message>
        <source>budget: %1</source>
        <translation>presupuesto: %1</translation>
    </message>
    <message>
        <source>Time, s before now</source>
        <translation>Tiempo, s antes de ahora</translation>
    </message>
</context>
<context>
    <name>glenoid::ToolPanel</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Choose a tool, then drag with the left button in the view. The wheel moves it in depth while you drag, Ctrl+wheel at any time.</source>
        <translation>Elija una herramienta y arrastre con el botón izquierdo en la vista. La rueda la mueve en profundidad mientras arrastra; Ctrl+rueda, en cualquier momento.</translation>
    </message>
    <message>
        <source>This scene has no tools.</source>
        <translation>Esta escena no tiene herramientas.</translation>
    </message>
    <message>
        <source>&amp;Follow the recorded input</source>
        <translation>&amp;Seguir la entrada grabada</translation>
    </message>
    <message>
        <source>Tools that nobody holds move as they were recorded</source>
        <translation>Las herramientas que nadie sostiene se mueven como se grabaron</translation>
    </message>
    <message>
        <source>Contact force on this tool</source>
        <translation>Fuerza de contacto sobre esta herramienta</translation>
    </message>
    <message>
        <source>Move this tool with the mouse</source>
        <translation>Mover esta herramienta con el ratón</translation>
    </message>
</context>
<context>
    <name>glenoid::TrainingSentences</name>
    <message>
        <source>tasks done, by their score</source>
        <translation>tareas hechas, según su puntuación</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>errores</translation>
    </message>
    <message>
        <source>tasks out of order</source>
        <translation>tareas fuera de orden</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>length of the path</source>
        <translation>longitud del recorrido</translation>
    </message>
    <message>
        <source>economy of the path</source>
        <translation>economía del recorrido</translation>
    </message>
    <message>
        <source>jerk (smaller is smoother)</source>
        <translation>sacudida (menor es más suave)</translation>
    </message>
    <message>
        <source>mean speed</source>
        <translation>velocidad media</translation>
    </message>
    <message>
        <source>largest force</source>
        <translation>fuerza máxima</translation>
    </message>
    <message>
        <source>mean force while touching</source>
        <translation>fuerza media al tocar</translation>
    </message>
    <message>
        <source>time touching</source>
        <translation>tiempo tocando</translation>
    </message>
    <message>
        <source>time pressed too hard</source>
        <translation>tiempo con demasiada fuerza</translation>
    </message>
    <message>
        <source>times pressed too hard</source>
        <translation>veces con demasiada fuerza</translation>
    </message>
    <message>
        <source>turning of the view</source>
        <translation>giro de la vista</translation>
    </message>
    <message>
        <source>sought place in view</source>
        <translation>lugar buscado a la vista</translation>
    </message>
    <message>
        <source>distance of what was found</source>
        <translation>distancia de lo encontrado</translation>
    </message>
    <message>
        <source>depth of what was found</source>
        <translation>profundidad de lo encontrado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1
Validated: %2</source>
        <translation>%1
Validado: %2</translation>
    </message>
    <message>
        <source>%1
Experimental: nobody has shown with this program that it tells skilled people from others.</source>
        <translation>%1
Experimental: nadie ha mostrado con este programa que distinga a personas expertas de otras.</translation>
    </message>
    <message>
        <source>later</source>
        <translation>después</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>por hacer</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecha</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>perdida</translation>
    </message>
    <message>
        <source>%1 of %2 tasks done</source>
        <translation>%1 de %2 tareas hechas</translation>
    </message>
    <message>
        <source>%1. %2 of 100 points: passed.</source>
        <translation>%1. %2 de 100 puntos: superado.</translation>
    </message>
    <message>
        <source>%1. %2 of 100 points: not passed.</source>
        <translation>%1. %2 de 100 puntos: no superado.</translation>
    </message>
</context>
<context>
    <name>glenoid::WindowRecords</name>
    <message>
        <source>Kept for %1.</source>
        <translation>Guardado para %1.</translation>
    </message>
    <message>
        <source>Being kept …</source>
        <translation>Guardando …</translation>
    </message>
    <message>
        <source>Runs of %1</source>
        <translation>Ejercicios de %1</translation>
    </message>
    <message>
        <source>Nothing is kept for %1 yet.</source>
        <translation>Todavía no hay nada guardado para %1.</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuándo</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Puntuación</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>sin terminar</translation>
    </message>
    <message>
        <source>, passed</source>
        <translation>, superado</translation>
    </message>
</context>
</TS>

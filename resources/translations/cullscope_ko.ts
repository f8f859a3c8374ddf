<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
<context>
    <name>HtmlReport</name>
    <message>
        <source>until the median is steady</source>
        <translation>중앙값이 안정될 때까지</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>카메라 경로</translation>
    </message>
    <message>
        <source>Poses measured</source>
        <translation>측정한 자세</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%2 중 %1</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>Pictures a frame</source>
        <translation>프레임당 그림</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>반복</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>프로세서</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>소프트웨어 OpenGL: 그래픽 카드의 시간이 아님</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>프로그램</translation>
    </message>
    <message>
        <source>Promise</source>
        <translation>보장</translation>
    </message>
    <message>
        <source>: broken</source>
        <translation>: 깨짐</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Frame, ms</source>
        <translation>프레임, ms</translation>
    </message>
    <message>
        <source>Cull, ms</source>
        <translation>컬링, ms</translation>
    </message>
    <message>
        <source>Submitted</source>
        <translation>제출</translation>
    </message>
    <message>
        <source>Missed pixels</source>
        <translation>놓친 픽셀</translation>
    </message>
    <message>
        <source>Covered pixels</source>
        <translation>덮인 픽셀</translation>
    </message>
    <message>
        <source>Cullscope: what culling gains and loses in %1</source>
        <translation>Cullscope: %1에서 컬링이 얻는 것과 잃는 것</translation>
    </message>
    <message>
        <source>stopped early: the poses measured until then</source>
        <translation>일찍 멈춤: 그때까지 측정한 자세</translation>
    </message>
    <message>
        <source>The command that repeats it</source>
        <translation>다시 실행하는 명령</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Every frame</source>
        <translation>모든 프레임</translation>
    </message>
    <message>
        <source>Conclusion</source>
        <translation>결론</translation>
    </message>
    <message>
        <source>The scene, as the active view showed it</source>
        <translation>활성 뷰에 보인 장면</translation>
    </message>
    <message>
        <source>Errors in the field&apos;s figures, with their 95 % intervals</source>
        <translation>분야에서 쓰는 수치로 본 오류와 95 % 구간</translation>
    </message>
</context>
<context>
    <name>Screenshot</name>
    <message>
        <source>%1: %2</source>
        <comment>what a colour means, how many</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>farther away than beside it, or missing (pixels)</source>
        <translation>옆보다 멀거나 빠진 픽셀</translation>
    </message>
    <message>
        <source>nearer than beside it (pixels)</source>
        <translation>옆보다 가까운 픽셀</translation>
    </message>
    <message>
        <source>software OpenGL</source>
        <translation>소프트웨어 OpenGL</translation>
    </message>
    <message>
        <source>box rejected by the %1</source>
        <comment>name of a plane</comment>
        <translation>상자를 제외한 면: %1</translation>
    </message>
    <message>
        <source>figures at %1 pixels</source>
        <translation>%1 픽셀에서의 수치</translation>
    </message>
    <message>
        <source>Triangles at %1 pixels:</source>
        <comment>heading of the legend&apos;s counts, size</comment>
        <translation>%1 픽셀에서의 삼각형:</translation>
    </message>
    <message>
        <source>within snapping, not lost (pixels)</source>
        <translation>맞춤 오차 안, 손실 아님(픽셀)</translation>
    </message>
</context>
<context>
    <name>SphericalModel</name>
    <message>
        <source>R: near</source>
        <translation>R: 가까움</translation>
    </message>
    <message>
        <source>far</source>
        <translation>멂</translation>
    </message>
    <message>
        <source>Only what the strategy submits is drawn: choose All triangles for the whole model.</source>
        <translation>전략이 제출한 것만 그려집니다. 모델 전체를 보려면 &apos;모든 삼각형&apos;을 선택하세요.</translation>
    </message>
</context>
<context>
    <name>ViewMenu</name>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Linked with the other views</source>
        <translation>다른 뷰와 연결</translation>
    </message>
    <message>
        <source>Watch view %1 from outside</source>
        <translation>%1 뷰를 밖에서 관찰</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>없음</translation>
    </message>
    <message>
        <source>Wipe: view %1 | this one</source>
        <translation>나란히: 뷰 %1 | 이 뷰</translation>
    </message>
    <message>
        <source>Pixels that differ from view %1</source>
        <translation>%1 뷰와 다른 픽셀</translation>
    </message>
    <message>
        <source>Picture size</source>
        <translation>그림 크기</translation>
    </message>
    <message>
        <source>The same in all views</source>
        <translation>모든 뷰에 똑같이</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>꼭짓점</translation>
    </message>
    <message>
        <source>Buffer objects</source>
        <translation>버퍼 객체</translation>
    </message>
    <message>
        <source>Vertex arrays of the program&apos;s memory</source>
        <translation>프로그램 메모리의 정점 배열</translation>
    </message>
    <message>
        <source>Vertex arrays: this OpenGL has no compatibility profile</source>
        <translation>정점 배열: 이 OpenGL에는 호환성 프로필이 없음</translation>
    </message>
    <message>
        <source>In this place</source>
        <translation>이 자리에</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>Below the picture</source>
        <translation>그림 아래에</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>기타…</translation>
    </message>
    <message>
        <source>Other (%1)…</source>
        <translation>기타(%1)…</translation>
    </message>
    <message>
        <source>Fits the window</source>
        <translation>창에 맞춤</translation>
    </message>
</context>
<context>
    <name>Wording</name>
    <message>
        <source>exact set</source>
        <translation>정확</translation>
    </message>
    <message>
        <source>lossless</source>
        <translation>무손실</translation>
    </message>
    <message>
        <source>lossy</source>
        <translation>손실</translation>
    </message>
    <message>
        <source>draws what is visible and nothing in vain</source>
        <translation>보이는 것만 빠짐없이 그림</translation>
    </message>
    <message>
        <source>loses no visible pixel, may draw in vain</source>
        <translation>보이는 픽셀은 잃지 않으나 헛되이 그릴 수 있음</translation>
    </message>
    <message>
        <source>may lose pixels: how many is measured</source>
        <translation>픽셀을 잃을 수 있음(몇 개인지 측정함)</translation>
    </message>
    <message>
        <source>front faces only</source>
        <translation>앞면만</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>양면</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>large scene: figures on request</source>
        <translation>큰 장면: 요청하면 측정</translation>
    </message>
    <message>
        <source>no figures</source>
        <translation>수치 없음</translation>
    </message>
    <message>
        <source>%1 · %2 % · %3 missed</source>
        <extracomment>Line 2 of a view&apos;s header: speed against the baseline, share of the triangles submitted, missed pixels.</extracomment>
        <translation>%1 · %2 % · 놓침 %3</translation>
    </message>
    <message>
        <source>Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling</source>
        <translation>속도: %1 fps = 1 / (컬링 + 그리기), 프레임당 %2, 그중 컬링 %3</translation>
    </message>
    <message>
        <source>Missed: %1 of %2 covered pixels, largest hole %3</source>
        <translation>놓침: 덮인 픽셀 %2개 중 %1개, 가장 큰 구멍 %3</translation>
    </message>
    <message>
        <source>Truth: item buffer of %1 × %2 pixels, %3</source>
        <translation>참값: %1 × %2 픽셀 아이템 버퍼, %3</translation>
    </message>
    <message>
        <source>Software OpenGL: %1</source>
        <translation>소프트웨어 OpenGL: %1</translation>
    </message>
    <message>
        <source>OpenGL: %1</source>
        <translation>OpenGL: %1</translation>
    </message>
    <message>
        <source>Submitted in %1 fragments that the strategy made of them</source>
        <translation>전략이 만든 삼각형 조각 %1개로 제출</translation>
    </message>
    <message>
        <source>In force, to hold the frame time: %1</source>
        <translation>프레임 시간을 지키려고 지금 쓰는 값: %1</translation>
    </message>
    <message>
        <source>Within the raster&apos;s snapping, and not lost: %1</source>
        <extracomment>Pixels that differ from the truth&apos;s only because OpenGL rounds corners to 1/256 pixel.</extracomment>
        <translation>래스터의 맞춤 오차 안에 있어 잃은 것이 아님: %1</translation>
    </message>
    <message>
        <source>%1 against %2, which draws the same sides, with its 95 % interval</source>
        <extracomment>Speed against a baseline, %2, and its 95 % interval: &quot;×3.1 (2.93 – 3.31)&quot;.</extracomment>
        <translation>같은 면을 그리는 %2에 대해 %1, 95 % 구간 포함</translation>
    </message>
    <message>
        <source>%1 against %2, which draws front faces only</source>
        <extracomment>The same against a baseline that draws front faces alone.</extracomment>
        <translation>앞면만 그리는 %2에 대해 %1</translation>
    </message>
    <message>
        <source>front faces only of closed objects, both sides of the others</source>
        <translation>닫힌 물체는 앞면만, 나머지는 양면</translation>
    </message>
    <message>
        <source>Submitted: %1 of %2 triangles. Visible, drawn or not: %3</source>
        <translation>제출: 삼각형 %2개 중 %1개. 그려지든 아니든 보이는 것: %3</translation>
    </message>
    <message>
        <source>Which one is faster is not decided.</source>
        <translation>어느 쪽이 빠른지는 정해지지 않았습니다.</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3.</source>
        <extracomment>A view&apos;s letter, how many times as fast, another view&apos;s letter.</extracomment>
        <translation>%1의 속도는 %3의 %2배입니다.</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3 (%4).</source>
        <extracomment>The same with the 95 % interval.</extracomment>
        <translation>%1의 속도는 %3의 %2배입니다(%4).</translation>
    </message>
    <message>
        <source>Any culling could gain at most %1 against %2: the visible triangles alone</source>
        <extracomment>What drawing exactly the visible triangles gains over a baseline, %2, and its 95 % interval: &quot;×3.1 (2.93 – 3.31)&quot;.</extracomment>
        <translation>컬링이 얻을 수 있는 최대: %2 대비 %1, 보이는 삼각형만 그릴 때</translation>
    </message>
    <message>
        <source>Of this headroom: %1</source>
        <extracomment>The share of what any culling could gain that this strategy gains.</extracomment>
        <translation>이 여유 중 비율: %1</translation>
    </message>
    <message>
        <source>Nothing could be gained here: drawing the visible triangles alone is %1 against %2</source>
        <extracomment>The speed of drawing exactly the visible triangles over a baseline, %2, and its 95 % interval: &quot;×0.92 (0.81 – 1.02)&quot;.</extracomment>
        <translation>여기서는 얻을 것이 없습니다: 보이는 삼각형만 그리면 %2 대비 %1입니다</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Nothing in the file had to be repaired.</source>
        <translation>파일에서 고칠 것이 없었습니다.</translation>
    </message>
    <message>
        <source>This view cannot be measured: %1</source>
        <translation>이 뷰를 측정할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install a graphics driver or Mesa.</source>
        <translation>이 화면에서 OpenGL 컨텍스트를 만들 수 없습니다. 그래픽 드라이버나 Mesa를 설치하세요.</translation>
    </message>
    <message>
        <source>The OpenGL context cannot be used on this display. Update the graphics driver.</source>
        <translation>이 화면에서 OpenGL 컨텍스트를 쓸 수 없습니다. 그래픽 드라이버를 업데이트하세요.</translation>
    </message>
    <message>
        <source>There is not enough memory to open %1. Choose a smaller model.</source>
        <translation>%1 파일을 열기에 메모리가 부족합니다. 더 작은 모델을 고르세요.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 파일을 열 수 없습니다: %2</translation>
    </message>
    <message>
        <source>Opening %1 was cancelled.</source>
        <translation>%1 열기를 취소했습니다.</translation>
    </message>
    <message>
        <source>The scene cannot be given to OpenGL: %1</source>
        <translation>장면을 OpenGL에 넘길 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The strategy %1 cannot be built for this scene: %2</source>
        <translation>이 장면에 %1 전략을 준비할 수 없습니다: %2</translation>
    </message>
    <message>
        <source>The Qt platform %1 has no OpenGL for windows. Unset QT_QPA_PLATFORM, or use cullbench, which needs no display.</source>
        <translation>Qt 플랫폼 %1에는 창을 위한 OpenGL이 없습니다. QT_QPA_PLATFORM을 지우거나 화면이 필요 없는 cullbench를 쓰세요.</translation>
    </message>
    <message>
        <source>There is no display: neither DISPLAY nor WAYLAND_DISPLAY is set. Start cullscope in a desktop session, or use cullbench, which needs no display.</source>
        <translation>화면이 없습니다. DISPLAY도 WAYLAND_DISPLAY도 설정되어 있지 않습니다. 데스크톱 세션에서 cullscope를 실행하거나 화면이 필요 없는 cullbench를 쓰세요.</translation>
    </message>
    <message>
        <source>This display offers no OpenGL 4.5. Update the graphics driver, or use cullbench, which needs no display.</source>
        <translation>이 화면은 OpenGL 4.5를 제공하지 않습니다. 그래픽 드라이버를 업데이트하거나 화면이 필요 없는 cullbench를 쓰세요.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another place or free some space.</source>
        <translation>%1 파일을 쓸 수 없습니다: %2. 다른 위치를 고르거나 공간을 비우세요.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>멈췄습니다.</translation>
    </message>
    <message>
        <source>There is no OpenGL context here: install a graphics driver with OpenGL 4.5, or Mesa.</source>
        <translation>여기에는 OpenGL 컨텍스트가 없습니다. OpenGL 4.5를 지원하는 그래픽 드라이버나 Mesa를 설치하세요.</translation>
    </message>
    <message>
        <source>OpenGL 4.5 is needed and this machine has %1 (%2): update the graphics driver, or use Mesa&apos;s software OpenGL with LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>OpenGL 4.5가 필요한데 이 컴퓨터에는 %1(%2)이 있습니다. 그래픽 드라이버를 업데이트하거나 LIBGL_ALWAYS_SOFTWARE=1로 Mesa의 소프트웨어 OpenGL을 쓰세요.</translation>
    </message>
    <message>
        <source>No OpenGL 4.5 context without a display: EGL&apos;s surfaceless and device platforms were both tried. Install libegl1 with Mesa (libgl1-mesa-dri) or the GPU&apos;s driver.</source>
        <translation>화면 없이 OpenGL 4.5 컨텍스트를 만들 수 없습니다. EGL의 surfaceless와 device 플랫폼을 모두 시도했습니다. libegl1과 Mesa(libgl1-mesa-dri) 또는 GPU 드라이버를 설치하세요.</translation>
    </message>
    <message>
        <source>This OpenGL cannot make a picture of %1x%2 pixels: choose a smaller size.</source>
        <translation>이 OpenGL로는 %1x%2 픽셀 그림을 만들 수 없습니다. 더 작은 크기를 고르세요.</translation>
    </message>
    <message>
        <source>The graphics driver refuses a shader: %1</source>
        <translation>그래픽 드라이버가 셰이더를 거부합니다: %1</translation>
    </message>
    <message>
        <source>Client vertex arrays need OpenGL&apos;s compatibility profile, which this driver does not give: use buffer objects (vbo).</source>
        <translation>클라이언트 정점 배열에는 OpenGL 호환 프로파일이 필요하지만 이 드라이버는 제공하지 않습니다. 버퍼 객체(vbo)를 쓰세요.</translation>
    </message>
    <message>
        <source>The graphics memory does not hold this scene (%1 bytes): use client vertex arrays or a smaller scene.</source>
        <translation>그래픽 메모리에 이 장면(%1바이트)이 들어가지 않습니다. 클라이언트 정점 배열이나 더 작은 장면을 쓰세요.</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>측정 중</translation>
    </message>
    <message>
        <source>No strategy is named: give one with -s.</source>
        <translation>전략이 지정되지 않았습니다. -s로 지정하세요.</translation>
    </message>
    <message>
        <source>The camera path has no poses.</source>
        <translation>카메라 경로에 자세가 없습니다.</translation>
    </message>
    <message>
        <source>The scene has no triangles: there is nothing to measure.</source>
        <translation>장면에 삼각형이 없어 측정할 것이 없습니다.</translation>
    </message>
    <message>
        <source>%1: pictures are written as .png, .jpg, .tif or .exr; choose one of these endings.</source>
        <translation>%1: 그림은 .png, .jpg, .tif, .exr로 씁니다. 이 가운데 하나를 고르세요.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 파일을 쓸 수 없습니다: %2</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: %2</source>
        <translation>%1 파일은 읽을 수 있는 그림이 아닙니다: %2</translation>
    </message>
    <message>
        <source>The scene has too many triangles for the ray reference.</source>
        <translation>광선 기준을 쓰기에는 장면의 삼각형이 너무 많습니다.</translation>
    </message>
    <message>
        <source>The scene has %1 triangles; the item buffer numbers at most 4294967294. Measure a part of it.</source>
        <translation>장면의 삼각형이 %1개입니다. 아이템 버퍼는 4294967294개까지 셀 수 있습니다. 일부만 측정하세요.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2. Check the path and the permissions.</source>
        <translation>%1 파일을 열 수 없습니다: %2. 경로와 권한을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 is a folder. Name a mesh file inside it.</source>
        <translation>%1은(는) 폴더입니다. 그 안의 메시 파일을 지정하세요.</translation>
    </message>
    <message>
        <source>%1 is empty. Fetch or export the file again.</source>
        <translation>%1 파일이 비어 있습니다. 파일을 다시 받거나 내보내세요.</translation>
    </message>
    <message>
        <source>%1 is not a regular file. Save the mesh in a file and name that.</source>
        <translation>%1은(는) 일반 파일이 아닙니다. 메시를 파일로 저장한 뒤 그 파일을 지정하세요.</translation>
    </message>
    <message>
        <source>%1 cannot be read after byte %2: %3. Copy the file again.</source>
        <translation>%1 파일을 %2바이트 뒤로 읽을 수 없습니다: %3. 파일을 다시 복사하세요.</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>파일 읽는 중</translation>
    </message>
    <message>
        <source>%1, line %2 is longer than %3 MB. Check that the file is a mesh in a text format.</source>
        <translation>%1 파일 %2행이 %3 MB보다 깁니다. 텍스트 형식의 메시 파일인지 확인하세요.</translation>
    </message>
    <message>
        <source>%1 is compressed twice. Unpack it once: xz -dk &quot;%1&quot; or gzip -dk &quot;%1&quot;.</source>
        <translation>%1 파일은 두 번 압축되어 있습니다. 한 번 푸세요: xz -dk &quot;%1&quot; 또는 gzip -dk &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>%1 unpacks to more than the %2 MB that may be used on this machine. Simplify the mesh or split the file.</source>
        <translation>%1 파일을 풀면 이 컴퓨터에서 쓸 수 있는 %2 MB보다 커집니다. 메시를 단순화하거나 파일을 나누세요.</translation>
    </message>
    <message>
        <source>%1, byte %2: the compressed data are damaged. Fetch the file again.</source>
        <translation>%1 파일 바이트 %2: 압축된 데이터가 손상되었습니다. 파일을 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within its compressed data. The file was cut off: fetch it again.</source>
        <translation>%1 파일이 압축된 데이터 안의 바이트 %2에서 끝납니다. 파일이 잘렸습니다: 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, byte %2: unpacking the file takes more memory than may be used on this machine. Compress it anew by a lower level, such as xz -6.</source>
        <translation>%1 파일 바이트 %2: 파일을 푸는 데 이 컴퓨터에서 쓸 수 있는 것보다 많은 메모리가 필요합니다. xz -6처럼 더 낮은 수준으로 다시 압축하세요.</translation>
    </message>
    <message>
        <source>Unpacking the file</source>
        <translation>파일 푸는 중</translation>
    </message>
    <message>
        <source>%1 is an archive or compressed. Unpack it first.</source>
        <translation>%1 파일은 보관 파일이거나 압축되어 있습니다. 먼저 푸세요.</translation>
    </message>
    <message>
        <source>%1 is a Git LFS pointer, not the mesh itself. Fetch the mesh with: git lfs pull.</source>
        <translation>%1 파일은 메시가 아니라 Git LFS 포인터입니다. git lfs pull로 메시를 받으세요.</translation>
    </message>
    <message>
        <source>%1 is UTF-16 text. Save it as UTF-8 or ASCII.</source>
        <translation>%1 파일은 UTF-16 텍스트입니다. UTF-8이나 ASCII로 저장하세요.</translation>
    </message>
    <message>
        <source>%1 is none of the mesh formats that are read (%2). Export the mesh in one of them.</source>
        <translation>%1 파일은 읽을 수 있는 메시 형식(%2)이 아닙니다. 이 가운데 하나로 내보내세요.</translation>
    </message>
    <message>
        <source>Checking the mesh</source>
        <translation>메시 검사 중</translation>
    </message>
    <message>
        <source>%1 needs more memory than this machine gives. Simplify the mesh or split the file.</source>
        <translation>%1 파일은 이 컴퓨터보다 많은 메모리가 필요합니다. 메시를 단순화하거나 파일을 나누세요.</translation>
    </message>
    <message>
        <source>Degenerate faces dropped (fewer than three different corners, or no area): %1.</source>
        <translation>버린 퇴화 면(서로 다른 꼭짓점이 셋보다 적거나 넓이가 없음): %1.</translation>
    </message>
    <message>
        <source>Duplicate faces dropped: %1.</source>
        <translation>버린 중복 면: %1.</translation>
    </message>
    <message>
        <source>Non-manifold edges kept (with more than two triangles): %1.</source>
        <translation>그대로 둔 비다양체 변(삼각형이 셋 이상): %1.</translation>
    </message>
    <message>
        <source>Vertices dropped whose coordinates are NaN, infinite or beyond 1e30, with the faces that use them: %1.</source>
        <translation>좌표가 NaN이거나 무한대 또는 1e30을 넘어 그 면과 함께 버린 꼭짓점: %1.</translation>
    </message>
    <message>
        <source>Faces dropped that name a vertex which does not exist: %1.</source>
        <translation>없는 꼭짓점을 가리켜 버린 면: %1.</translation>
    </message>
    <message>
        <source>Vertices dropped that no face uses: %1.</source>
        <translation>어느 면도 쓰지 않아 버린 꼭짓점: %1.</translation>
    </message>
    <message>
        <source>%1 needs about %2 MB of memory, more than the %3 MB allowed. Simplify the mesh, split the file, or allow more.</source>
        <translation>%1 파일은 허용된 %3 MB보다 많은 약 %2 MB의 메모리가 필요합니다. 메시를 단순화하거나 파일을 나누거나 한도를 늘리세요.</translation>
    </message>
    <message>
        <source>%1 has more than 2,147,483,647 vertices in one object. Split the object.</source>
        <translation>%1 파일의 한 물체에 꼭짓점이 2,147,483,647개보다 많습니다. 물체를 나누세요.</translation>
    </message>
    <message>
        <source>%1: the object &quot;%2&quot; is smaller than 1e-30. Scale it up.</source>
        <translation>%1: &quot;%2&quot; 물체가 1e-30보다 작습니다. 크기를 키우세요.</translation>
    </message>
    <message>
        <source>%1 holds no faces. Export the mesh with its faces, not only points or lines.</source>
        <translation>%1 파일에 면이 없습니다. 점이나 선만이 아니라 면까지 내보내세요.</translation>
    </message>
    <message>
        <source>%1 holds no usable face: all %2 are without area, out of range or not finite. Export the mesh again.</source>
        <translation>%1 파일에 쓸 수 있는 면이 없습니다. %2개 모두 넓이가 없거나 범위를 벗어났거나 유한하지 않습니다. 메시를 다시 내보내세요.</translation>
    </message>
    <message>
        <source>Normals made from the faces because some were missing or unusable: %1.</source>
        <translation>없거나 쓸 수 없어 면에서 만든 법선: %1.</translation>
    </message>
    <message>
        <source>Polygons with so many corners that they were cut as fans, which may cover too much: %1.</source>
        <translation>꼭짓점이 너무 많아 부채꼴로 나눈 다각형(지나치게 덮을 수 있음): %1.</translation>
    </message>
    <message>
        <source>Duplicate faces and non-manifold edges were not looked for: the mesh has more than %1 faces.</source>
        <translation>면이 %1개보다 많아 중복 면과 비다양체 변는 찾지 않았습니다.</translation>
    </message>
    <message>
        <source>%1, line %2 goes on for more than %3 MB. Check that the file is a mesh in a text format.</source>
        <translation>%1 파일 %2행이 %3 MB 넘게 이어집니다. 텍스트 형식의 메시 파일인지 확인하세요.</translation>
    </message>
    <message>
        <source>%1, line %2: a vertex or normal has only %3 of 3 coordinates. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: 꼭짓점이나 법선의 좌표가 3개 중 %3개뿐입니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a number. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: &quot;%3&quot;은(는) 수가 아닙니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a corner of a face. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: &quot;%3&quot;은(는) 면의 꼭짓점이 아닙니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: the PLY header has no end_header. Fetch or export the file again.</source>
        <translation>%1 파일 %2행: PLY 헤더에 end_header가 없습니다. 파일을 다시 받거나 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; cannot be understood in a PLY header. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: PLY 헤더의 &quot;%3&quot;을(를) 이해할 수 없습니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2 promises %3 of &quot;%4&quot;, but only %5 bytes follow the header. The file was cut off or changed: fetch it again.</source>
        <translation>%1 파일 %2행은 &quot;%4&quot; %3개를 약속하지만 헤더 뒤에 %5바이트뿐입니다. 파일이 잘렸거나 바뀌었으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, line %2 promises %3 of &quot;%4&quot;, which have no properties. Export the file again.</source>
        <translation>%1 파일 %2행은 속성이 없는 &quot;%4&quot; %3개를 약속합니다. 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>Lines passed over because their keyword is unknown: %1, first line %2.</source>
        <translation>알 수 없는 키워드라 건너뛴 행: %1, 첫 행 %2.</translation>
    </message>
    <message>
        <source>%1 promises %2 vertices and %3 faces, but only %4 bytes follow. The file was cut off or changed: fetch it again.</source>
        <translation>%1 파일은 꼭짓점 %2개와 면 %3개를 약속하지만 뒤에 %4바이트뿐입니다. 파일이 잘렸거나 바뀌었으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1 is an OFF file of another number of dimensions than three. Export a plain OFF file.</source>
        <translation>%1 파일은 3차원이 아닌 OFF 파일입니다. 일반 OFF 파일로 내보내세요.</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, before everything that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 파일은 약속한 내용이 다 나오기 전 %2바이트에서 끝납니다. 파일이 잘렸으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, byte %2 promises %3 values, but %4 bytes are left. The file was cut off or changed: fetch it again.</source>
        <translation>%1 파일 %2바이트는 값 %3개를 약속하지만 %4바이트만 남았습니다. 파일이 잘렸거나 바뀌었으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, byte %2 cannot stand here in an OM file. The file was changed: fetch or export it again.</source>
        <translation>%1 파일 %2바이트는 OM 파일에서 이 자리에 올 수 없습니다. 파일이 바뀌었으니 다시 받거나 내보내세요.</translation>
    </message>
    <message>
        <source>%1 is no OM file: it does not begin with OMT, OMQ or OMP. Export the mesh again.</source>
        <translation>%1 파일은 OMT, OMQ, OMP로 시작하지 않으므로 OM 파일이 아닙니다. 메시를 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1 promises %2 vertices, %3 faces and %4 edges, but only %5 bytes follow. The file was cut off or changed: fetch it again.</source>
        <translation>%1 파일은 꼭짓점 %2개, 면 %3개, 모서리 %4개를 약속하지만 뒤에 %5바이트뿐입니다. 파일이 잘렸거나 바뀌었으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1: the edges of face %2 do not close up. The file was changed: fetch or export it again.</source>
        <translation>%1: 면 %2의 모서리가 닫히지 않습니다. 파일이 바뀌었으니 다시 받거나 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: the vertices have no x, y and z. Export the file again.</source>
        <translation>%1 파일 %2행: 꼭짓점에 x, y, z가 없습니다. 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within number %3 of the %4 of &quot;%5&quot; that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 파일은 약속한 &quot;%5&quot; %4개 중 %3번째 안인 %2바이트에서 끝납니다. 파일이 잘렸으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, byte %2: number %3 of &quot;%4&quot; promises a list of %5, but %6 bytes are left. The file was cut off or changed: fetch it again.</source>
        <translation>%1 파일 %2바이트: &quot;%4&quot;의 %3번째가 길이 %5의 목록을 약속하지만 %6바이트만 남았습니다. 파일이 잘렸거나 바뀌었으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, line %2: a list cannot have %3 values. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: 목록에 값이 %3개일 수 없습니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>%1, line %2: the faces have no list of whole vertex numbers (vertex_indices). Export the file again.</source>
        <translation>%1 파일 %2행: 면에 정수 꼭짓점 번호 목록(vertex_indices)이 없습니다. 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>Bytes after the end of the mesh that were passed over: %1.</source>
        <translation>메시가 끝난 뒤 건너뛴 바이트: %1.</translation>
    </message>
    <message>
        <source>%1 ends at byte %2, within the header of a binary STL. The file was cut off: fetch it again.</source>
        <translation>%1 파일은 이진 STL 헤더 안인 %2바이트에서 끝납니다. 파일이 잘렸으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, byte 80 promises %2 triangles, but the file has room for %3. The file is no STL or was cut off: fetch it again.</source>
        <translation>%1 파일 80바이트는 삼각형 %2개를 약속하지만 파일에는 %3개 자리뿐입니다. STL이 아니거나 잘린 파일이니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; cannot stand here in an STL file. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: STL 파일의 이 자리에 &quot;%3&quot;이(가) 올 수 없습니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>Simplifying the mesh</source>
        <translation>메시 단순화 중</translation>
    </message>
    <message>
        <source>Changing the mesh to so many triangles needs about %1 MB of memory, more than three quarters of this machine&apos;s. Ask for fewer triangles.</source>
        <translation>메시를 그만큼의 삼각형으로 바꾸려면 이 컴퓨터 메모리의 4분의 3이 넘는 약 %1 MB가 필요합니다. 삼각형 수를 줄이세요.</translation>
    </message>
    <message>
        <source>Subdividing the mesh</source>
        <translation>메시 세분 중</translation>
    </message>
    <message>
        <source>A mesh cannot be changed to or from %1 triangles. Ask for at least one triangle.</source>
        <translation>메시를 삼각형 %1개로, 또는 %1개에서 바꿀 수 없습니다. 삼각형을 하나 이상 지정하세요.</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; has no surface that could be simplified or subdivided.</source>
        <translation>메시 &quot;%1&quot;에는 단순화하거나 세분할 면이 없습니다.</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; cannot be changed to %2 triangles: its pieces hold together only down to %3. Ask for at least that many.</source>
        <translation>&quot;%1&quot; 메시를 삼각형 %2개로 바꿀 수 없습니다. 조각들은 %3개까지만 줄일 수 있습니다. 그 이상을 지정하세요.</translation>
    </message>
    <message>
        <source>Writing the file</source>
        <translation>파일 쓰는 중</translation>
    </message>
    <message>
        <source>%1: meshes are written as .obj, .ply or .stl. Choose one of these endings.</source>
        <translation>%1: 메시는 .obj, .ply, .stl로 씁니다. 이 가운데 하나를 고르세요.</translation>
    </message>
    <message>
        <source>%1: the scene has too many triangles for one file of this format. Write an OBJ file.</source>
        <translation>%1: 이 형식의 파일 하나에 담기에는 장면의 삼각형이 너무 많습니다. OBJ 파일로 쓰세요.</translation>
    </message>
    <message>
        <source>%1 ends after line %2, before everything that it promises. The file was cut off: fetch it again.</source>
        <translation>%1 파일은 약속한 내용이 다 나오기 전 %2행에서 끝납니다. 파일이 잘렸으니 다시 받으세요.</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a number that can stand here. Correct the line or export the file again.</source>
        <translation>%1 파일 %2행: &quot;%3&quot;은(는) 이 자리에 올 수 있는 수가 아닙니다. 행을 고치거나 파일을 다시 내보내세요.</translation>
    </message>
    <message>
        <source>The camera&apos;s eye, target and up must be finite numbers.</source>
        <translation>카메라의 눈, 목표, 위쪽은 유한한 수여야 합니다.</translation>
    </message>
    <message>
        <source>The camera&apos;s eye and target are the same point: move one of them.</source>
        <translation>카메라의 눈과 목표가 같은 점입니다. 하나를 옮기세요.</translation>
    </message>
    <message>
        <source>The camera&apos;s up vector is zero: give it a direction.</source>
        <translation>카메라의 위쪽 벡터가 0입니다. 방향을 지정하세요.</translation>
    </message>
    <message>
        <source>The field of view must lie between 0 and 180 degrees, not %1.</source>
        <translation>시야각은 0도와 180도 사이여야 하며 %1도는 안 됩니다.</translation>
    </message>
    <message>
        <source>The near distance must be above 0 and below the far distance (near %1, far %2).</source>
        <translation>가까운 거리는 0보다 크고 먼 거리보다 작아야 합니다(가까운 거리 %1, 먼 거리 %2).</translation>
    </message>
    <message>
        <source>A picture is 1 to 16384 pixels wide and high, not %1x%2.</source>
        <translation>그림의 너비와 높이는 1~16384픽셀이어야 하며 %1x%2는 안 됩니다.</translation>
    </message>
    <message>
        <source>The path %1 needs a number of poses between 1 and 1000000 after the colon.</source>
        <translation>경로 %1에는 콜론 뒤에 1~1000000의 자세 수가 필요합니다.</translation>
    </message>
    <message>
        <source>%1: pose %2: &quot;%3&quot; must be three numbers.</source>
        <translation>%1: 자세 %2: &quot;%3&quot;은(는) 수 세 개여야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a number.</source>
        <translation>%1: &quot;%2&quot;은(는) 수여야 합니다.</translation>
    </message>
    <message>
        <source>%1 cannot be opened: check the name and that you may read it.</source>
        <translation>%1 파일을 열 수 없습니다. 이름과 읽기 권한을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 is not JSON: it breaks off at byte %2. A camera path has the fields fovy_deg, near, far and poses.</source>
        <translation>%1 파일은 JSON이 아닙니다. %2바이트에서 끊깁니다. 카메라 경로에는 fovy_deg, near, far, poses 필드가 있습니다.</translation>
    </message>
    <message>
        <source>%1: a camera path needs a list &quot;poses&quot; with at least one pose.</source>
        <translation>%1: 카메라 경로에는 자세가 하나 이상인 &quot;poses&quot; 목록이 필요합니다.</translation>
    </message>
    <message>
        <source>%1: pose %2: %3</source>
        <translation>%1: 자세 %2: %3</translation>
    </message>
    <message>
        <source>N poses on a circle at three times the scene&apos;s radius, 15 degrees above it</source>
        <translation>장면 반지름의 세 배 거리, 15도 위의 원을 따르는 N개 자세</translation>
    </message>
    <message>
        <source>N poses spread evenly around the scene at three times its radius</source>
        <translation>장면 반지름의 세 배 거리에 고르게 퍼진 N개 자세</translation>
    </message>
    <message>
        <source>N poses on a walk into the scene, looking ahead</source>
        <translation>앞을 보며 장면 안으로 걸어 들어가는 N개 자세</translation>
    </message>
    <message>
        <source>%1: %2=%3 is not a number between %4 and %5.</source>
        <translation>%1: %2=%3은(는) %4과(와) %5 사이의 수가 아닙니다.</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;. It has: %3.</source>
        <translation>%1에는 &quot;%2&quot; 매개변수가 없습니다. 있는 것: %3.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is not of the form key=value.</source>
        <translation>%1: &quot;%2&quot;은(는) key=value 꼴이 아닙니다.</translation>
    </message>
    <message>
        <source>No bunny is installed here. Install the package glmark2-data, or name a folder that holds bunny.obj with --models DIR or CULLSCOPE_MODELS.</source>
        <translation>토끼 모델이 설치되어 있지 않습니다. glmark2-data 패키지를 설치하거나, bunny.obj가 있는 폴더를 --models DIR 또는 CULLSCOPE_MODELS로 지정하세요.</translation>
    </message>
    <message>
        <source>mesh: names no file. Write mesh:FILE,triangles=N.</source>
        <translation>mesh:에 파일이 없습니다. mesh:FILE,triangles=N처럼 쓰세요.</translation>
    </message>
    <message>
        <source>how many triangles, to the nearest that the shape&apos;s grid allows</source>
        <translation>삼각형 수(형상의 격자가 허용하는 가장 가까운 수)</translation>
    </message>
    <message>
        <source>the Stanford bunny, from an installed model file</source>
        <translation>설치된 모델 파일의 스탠퍼드 토끼</translation>
    </message>
    <message>
        <source>Newell&apos;s teapot, tessellated from its 32 Bézier patches</source>
        <translation>베지에 패치 32개로 만든 뉴얼의 찻주전자</translation>
    </message>
    <message>
        <source>a unit sphere, from an icosahedron</source>
        <translation>정이십면체에서 만든 단위 구</translation>
    </message>
    <message>
        <source>a torus of radii 1 and 0.25: closed, not star-shaped</source>
        <translation>반지름 1과 0.25의 원환면: 닫혀 있고 별모양이 아님</translation>
    </message>
    <message>
        <source>a tube around a torus knot: hides much of itself</source>
        <translation>원환 매듭을 따라가는 관: 자신을 많이 가림</translation>
    </message>
    <message>
        <source>a star-shaped body with random bumps</source>
        <translation>무작위로 울퉁불퉁한 별모양 입체</translation>
    </message>
    <message>
        <source>number that the random shape starts from</source>
        <translation>무작위 형상의 시작 수</translation>
    </message>
    <message>
        <source>a grid of n by n copies of a mesh, each of radius 1</source>
        <translation>반지름 1인 메시를 n × n으로 늘어놓은 격자</translation>
    </message>
    <message>
        <source>copies along each side</source>
        <translation>한 변의 사본 수</translation>
    </message>
    <message>
        <source>distance between neighbours</source>
        <translation>이웃 사이의 거리</translation>
    </message>
    <message>
        <source>a mesh file simplified or subdivided: mesh:FILE,triangles=N</source>
        <translation>단순화하거나 세분한 메시 파일: mesh:FILE,triangles=N</translation>
    </message>
    <message>
        <source>how many triangles to make of it</source>
        <translation>만들 삼각형 수</translation>
    </message>
    <message>
        <source>No scene is named. Give a mesh file or a generator such as bunny or sphere:triangles=1e5.</source>
        <translation>장면이 지정되지 않았습니다. 메시 파일이나 bunny, sphere:triangles=1e5 같은 생성기를 지정하세요.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a file nor a generator. Generators: %2.</source>
        <translation>&quot;%1&quot;은(는) 파일도 생성기도 아닙니다. 생성기: %2.</translation>
    </message>
    <message>
        <source>All triangles</source>
        <translation>모든 삼각형</translation>
    </message>
    <message>
        <source>Draws every triangle, both sides: what the papers compare with.</source>
        <translation>모든 삼각형을 양면으로 그립니다. 논문들이 비교하는 기준입니다.</translation>
    </message>
    <message>
        <source>Back-face culling</source>
        <translation>뒷면 제거</translation>
    </message>
    <message>
        <source>Draws every triangle and lets OpenGL drop those that face away: the strong baseline.</source>
        <translation>모든 삼각형을 그리되 등진 면은 OpenGL이 버립니다. 강한 기준입니다.</translation>
    </message>
    <message>
        <source>Which faces are drawn: both sides, or only those whose front is turned to the eye.</source>
        <translation>그리는 면: 양면, 또는 앞이 눈을 향한 면만.</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>양면</translation>
    </message>
    <message>
        <source>front sides only</source>
        <translation>앞면만</translation>
    </message>
    <message>
        <source>View-frustum culling</source>
        <translation>절두체 컬링</translation>
    </message>
    <message>
        <source>Leaves out objects whose bounds lie outside one of the six planes of the view.</source>
        <translation>경계가 절두체의 여섯 평면 중 하나의 바깥에 있는 물체를 뺍니다.</translation>
    </message>
    <message>
        <source>How a bounding box is tested against a plane.</source>
        <translation>경계 상자를 평면과 비교하는 방법.</translation>
    </message>
    <message>
        <source>by its corner farthest inside</source>
        <translation>가장 안쪽 꼭짓점으로</translation>
    </message>
    <message>
        <source>by the length of its extent vector (wastes corners)</source>
        <translation>크기 벡터의 길이로(모서리를 낭비함)</translation>
    </message>
    <message>
        <source>%1=%2: %1 is true or false.</source>
        <translation>%1=%2: %1은(는) true 또는 false입니다.</translation>
    </message>
    <message>
        <source>%1=%2: %1 is one of %3.</source>
        <translation>%1=%2: %1은(는) %3 중 하나입니다.</translation>
    </message>
    <message>
        <source>%1=%2: %1 is a whole number between %3 and %4.</source>
        <translation>%1=%2: %1은(는) %3과(와) %4 사이의 정수입니다.</translation>
    </message>
    <message>
        <source>%1=%2: %1 is a number between %3 and %4.</source>
        <translation>%1=%2: %1은(는) %3과(와) %4 사이의 수입니다.</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot; here. Known: %2.</source>
        <translation>여기에는 &quot;%1&quot; 매개변수가 없습니다. 알려진 것: %2.</translation>
    </message>
    <message>
        <source>There is no strategy &quot;%1&quot;. Known: %2.</source>
        <translation>&quot;%1&quot; 전략이 없습니다. 알려진 것: %2.</translation>
    </message>
    <message>
        <source>outside the frustum</source>
        <translation>절두체 밖</translation>
    </message>
    <message>
        <source>back-facing</source>
        <translation>뒷면</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>가려짐</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>너무 작음</translation>
    </message>
    <message>
        <source>This view cannot be drawn: %1</source>
        <translation>이 뷰를 그릴 수 없습니다: %1</translation>
    </message>
    <message>
        <source>%1 is a folder or a device: name a file to write.</source>
        <translation>%1은(는) 폴더나 장치입니다. 쓸 파일의 이름을 지정하세요.</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>그런 파일이나 폴더가 없습니다</translation>
    </message>
    <message>
        <source>a part of the path is no folder</source>
        <translation>경로의 일부가 폴더가 아닙니다</translation>
    </message>
    <message>
        <source>permission is denied</source>
        <translation>권한이 없습니다</translation>
    </message>
    <message>
        <source>the place is read-only</source>
        <translation>읽기 전용인 곳입니다</translation>
    </message>
    <message>
        <source>no space is left</source>
        <translation>남은 공간이 없습니다</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>폴더입니다</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>이름이 너무 깁니다</translation>
    </message>
    <message>
        <source>the device reports an error</source>
        <translation>장치가 오류를 알렸습니다</translation>
    </message>
    <message>
        <source>The picture cannot be made: %1.</source>
        <translation>그림을 만들 수 없습니다: %1.</translation>
    </message>
    <message>
        <source>%1 takes between %2 and %3 triangles, not %4.</source>
        <translation>%1의 삼각형 수는 %2에서 %3까지이며 %4은(는) 안 됩니다.</translation>
    </message>
    <message>
        <source>Tessellating the shape</source>
        <translation>모양을 삼각형으로 나누는 중</translation>
    </message>
    <message>
        <source>%1 is no camera path file that can be read: check the name.</source>
        <translation>%1은(는) 읽을 수 있는 카메라 경로 파일이 아닙니다. 이름을 확인하세요.</translation>
    </message>
    <message>
        <source>%1 holds a number that is too large. A camera path has the fields fovy_deg, near, far and poses.</source>
        <translation>%1에 너무 큰 수가 있습니다. 카메라 경로에는 fovy_deg, near, far, poses 필드가 있습니다.</translation>
    </message>
    <message>
        <source>%1: %2 has no value.</source>
        <translation>%1: %2에 값이 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2 is a whole number, not %3.</source>
        <translation>%1: %2은(는) 정수여야 하며 %3은(는) 안 됩니다.</translation>
    </message>
    <message>
        <source>%1 triangles were made where %2 were asked for: a closed mesh has an even number.</source>
        <translation>삼각형 %2개를 요청했으나 %1개를 만들었습니다. 닫힌 메시의 삼각형 수는 짝수입니다.</translation>
    </message>
    <message>
        <source>listing</source>
        <translation>목록 만들기</translation>
    </message>
    <message>
        <source>plane tests</source>
        <translation>평면 검사</translation>
    </message>
    <message>
        <source>No camera path was recorded yet: record one, or add the present camera to it.</source>
        <translation>기록된 카메라 경로가 아직 없습니다. 경로를 기록하거나 현재 카메라를 추가하십시오.</translation>
    </message>
    <message>
        <source>There is not enough memory for this experiment. Choose a smaller scene.</source>
        <translation>이 실험을 하기에 메모리가 부족합니다. 더 작은 장면을 고르십시오.</translation>
    </message>
    <message>
        <source>The experiment cannot be run: %1</source>
        <translation>실험을 실행할 수 없습니다: %1</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot;: %3</source>
        <translation>%1: &quot;%2&quot;: %3</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be one of these words: %3.</source>
        <translation>%1: &quot;%2&quot;은(는) 다음 낱말 중 하나여야 합니다: %3.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a group of fields in braces.</source>
        <translation>%1: &quot;%2&quot;은(는) 중괄호로 묶인 필드여야 합니다.</translation>
    </message>
    <message>
        <source>%1: the field &quot;%2&quot; is missing.</source>
        <translation>%1: &quot;%2&quot; 필드가 없습니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a list of 1 to %3 entries.</source>
        <translation>%1: &quot;%2&quot;은(는) 1개에서 %3개까지의 항목으로 된 목록이어야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a number between %3 and %4.</source>
        <translation>%1: &quot;%2&quot;은(는) %3에서 %4 사이의 수여야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a whole number between %3 and %4.</source>
        <translation>%1: &quot;%2&quot;은(는) %3에서 %4 사이의 정수여야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be true or false.</source>
        <translation>%1: &quot;%2&quot;은(는) true 또는 false여야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be a text in quotes.</source>
        <translation>%1: &quot;%2&quot;은(는) 따옴표로 묶인 글이어야 합니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; must be three numbers.</source>
        <translation>%1: &quot;%2&quot;은(는) 세 개의 수여야 합니다.</translation>
    </message>
    <message>
        <source>There is not enough memory to draw this view. Make the picture or the scene smaller.</source>
        <translation>이 뷰를 그릴 메모리가 부족합니다. 그림이나 장면을 줄이십시오.</translation>
    </message>
    <message>
        <source>There is no memory for a picture of %1x%2 pixels: choose a smaller size.</source>
        <translation>%1x%2 픽셀의 그림을 위한 메모리가 없습니다: 더 작은 크기를 고르십시오.</translation>
    </message>
    <message>
        <source>%1 is not there any more; it was taken off the list of recent files.</source>
        <translation>%1이(가) 더 이상 없어 최근 파일 목록에서 뺐습니다.</translation>
    </message>
    <message>
        <source>There is no memory for this picture: choose a smaller size.</source>
        <translation>이 그림을 위한 메모리가 없습니다: 더 작은 크기를 고르십시오.</translation>
    </message>
    <message>
        <source>A picture of %1x%2 pixels is too large: at most 16384 pixels a side can be saved.</source>
        <translation>%1x%2 픽셀의 그림은 너무 큽니다: 한 변에 최대 16384 픽셀까지 저장할 수 있습니다.</translation>
    </message>
    <message>
        <source>In %1x%2 pixels there is no room for the pictures beside legend and caption: choose a larger size or leave those out.</source>
        <translation>%1x%2 픽셀에는 범례와 설명 옆에 그림이 들어갈 자리가 없습니다: 더 큰 크기를 고르거나 그것들을 빼십시오.</translation>
    </message>
    <message>
        <source>There is no picture to save yet: open a scene and wait until it is drawn.</source>
        <translation>아직 저장할 그림이 없습니다: 장면을 열고 그려질 때까지 기다리십시오.</translation>
    </message>
    <message>
        <source>There is no folder %1: choose another one.</source>
        <translation>%1 폴더가 없습니다: 다른 폴더를 고르십시오.</translation>
    </message>
    <message>
        <source>Nothing can be written into the folder %1: choose another one.</source>
        <translation>폴더 %1에 쓸 수 없습니다: 다른 폴더를 고르십시오.</translation>
    </message>
    <message>
        <source>The file has no name: give it one, such as {scene}-{n}.png.</source>
        <translation>파일 이름이 없습니다: {scene}-{n}.png 같은 이름을 주십시오.</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: it is not JSON from byte %2 on.</source>
        <translation>%1은(는) 읽을 수 있는 세션이 아닙니다. %2번째 바이트부터 JSON이 아닙니다.</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: a number in it is too large.</source>
        <translation>%1은(는) 읽을 수 있는 세션이 아닙니다. 너무 큰 수가 들어 있습니다.</translation>
    </message>
    <message>
        <source>%1 was saved by a newer Cullscope: install that one to open it.</source>
        <translation>%1은(는) 더 새로운 Cullscope에서 저장되었습니다. 열려면 그 버전을 설치하십시오.</translation>
    </message>
    <message>
        <source>name a mesh file or a generator such as bunny.</source>
        <translation>메시 파일이나 bunny 같은 생성기를 지정하십시오.</translation>
    </message>
    <message>
        <source>a view can watch only another one that is no observer itself.</source>
        <translation>뷰는 관찰자가 아닌 다른 뷰만 관찰할 수 있습니다.</translation>
    </message>
    <message>
        <source>the near distance must be above 0.</source>
        <translation>가까운 거리는 0보다 커야 합니다.</translation>
    </message>
    <message>
        <source>There is no scene to save yet: open one first.</source>
        <translation>저장할 장면이 아직 없습니다. 먼저 장면을 여십시오.</translation>
    </message>
    <message>
        <source>The name of the scene&apos;s file is no UTF-8, which a session needs: rename the file.</source>
        <translation>장면 파일의 이름이 세션에 필요한 UTF-8이 아닙니다. 파일 이름을 바꾸십시오.</translation>
    </message>
    <message>
        <source>%1 is no session that Cullscope saved. Open a mesh, a session, or a picture of Cullscope.</source>
        <translation>%1은(는) Cullscope가 저장한 세션이 아닙니다. 메시, 세션 또는 Cullscope의 그림을 여십시오.</translation>
    </message>
    <message>
        <source>%1 does not say what it shows: only pictures that Cullscope saved can be opened.</source>
        <translation>%1에는 무엇을 보여 주는지 적혀 있지 않습니다. Cullscope가 저장한 그림만 열 수 있습니다.</translation>
    </message>
    <message>
        <source>The scene has %1 objects now, no longer %2: all of them are shown.</source>
        <translation>장면의 물체가 이제 %2개가 아니라 %1개입니다. 모두 표시합니다.</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1을(를) 저장했습니다.</translation>
    </message>
    <message>
        <source>File names have no field {%1}. There are {scene}, {strategy}, {n} and {n:04}.</source>
        <translation>파일 이름에 {%1}이라는 자리표시자는 없습니다. {scene}, {strategy}, {n}, {n:04}가 있습니다.</translation>
    </message>
    <message>
        <source>%1 exists already: put {n} into the file name, and every picture gets a number of its own.</source>
        <translation>%1이(가) 이미 있습니다. 파일 이름에 {n}을 넣으면 그림마다 번호가 붙습니다.</translation>
    </message>
    <message>
        <source>Colours by verdict need %1 bytes in one buffer and this OpenGL gives %2: show the scene shaded, or a part of it.</source>
        <translation>판정별 색에는 버퍼 하나에 %1바이트가 필요하지만 이 OpenGL은 %2바이트만 제공합니다: 장면을 음영으로 표시하거나 일부만 표시하십시오.</translation>
    </message>
    <message>
        <source>%1: what the picture shows takes %2 bytes to describe, and this format holds %3. Write a .png or .exr file.</source>
        <translation>%1: 그림의 내용을 적는 데 %2바이트가 필요하지만 이 형식에는 %3바이트만 들어갑니다. .png 또는 .exr 파일로 쓰세요.</translation>
    </message>
    <message>
        <source>%1 is %2x%3 pixels large or no flat picture: pictures of 1 to 16384 pixels a side are read.</source>
        <translation>%1은(는) 크기가 %2x%3 픽셀이거나 평면 그림이 아닙니다. 한 변이 1~16384픽셀인 그림만 읽습니다.</translation>
    </message>
    <message>
        <source>drawn and visible</source>
        <translation>그려지고 보임</translation>
    </message>
    <message>
        <source>drawn in vain</source>
        <translation>헛되이 그려짐</translation>
    </message>
    <message>
        <source>wrongly culled</source>
        <translation>잘못 제거됨</translation>
    </message>
    <message>
        <source>The mesh &quot;%1&quot; would fall into %2 parts; at most %3 can be objects. Split it by=clusters with more triangles each.</source>
        <translation>&quot;%1&quot; 메시가 %2개 조각으로 나뉩니다. 물체는 최대 %3개까지 가능합니다. by=clusters로 조각마다 삼각형을 더 많이 주어 나누세요.</translation>
    </message>
    <message>
        <source>Splitting the mesh</source>
        <translation>메시를 나누는 중</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in &quot;%2&quot; is neither an object&apos;s number nor a range. Hidden objects are written as in 3,7-9.</source>
        <translation>&quot;%2&quot;의 &quot;%1&quot;은(는) 물체 번호도 범위도 아닙니다. 숨길 물체는 3,7-9처럼 씁니다.</translation>
    </message>
    <message>
        <source>There is no object %1 to hide: the scene has %2 objects, counted from 0.</source>
        <translation>숨길 물체 %1이(가) 없습니다. 장면의 물체는 %2개이며 0부터 셉니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has %2 triangles, too many to be one mesh.</source>
        <translation>&quot;%1&quot;의 삼각형은 %2개로, 메시 하나로 만들기에는 너무 많습니다.</translation>
    </message>
    <message>
        <source>split: by=%1 is unknown. Write by=components or by=clusters.</source>
        <translation>split: by=%1은(는) 알 수 없습니다. by=components 또는 by=clusters로 쓰세요.</translation>
    </message>
    <message>
        <source>split: triangles is the size of clusters. Write by=clusters with it, or leave it out.</source>
        <translation>split: triangles는 클러스터의 크기입니다. by=clusters와 함께 쓰거나 빼세요.</translation>
    </message>
    <message>
        <source>mesh file, or a generator with its own parameters</source>
        <translation>메시 파일, 또는 자체 매개변수가 있는 생성기</translation>
    </message>
    <message>
        <source>a mesh with every object split, so that there are objects to leave out; draws the same picture</source>
        <translation>모든 물체를 나눈 메시. 뺄 수 있는 물체가 생기며, 그림은 같습니다</translation>
    </message>
    <message>
        <source>components: what hangs together becomes an object; clusters: compact pieces of like size do</source>
        <translation>components: 이어진 것마다 물체가 됩니다. clusters: 크기가 비슷한 밀집 조각마다 물체가 됩니다</translation>
    </message>
    <message>
        <source>how many triangles a cluster has at most (with by=clusters)</source>
        <translation>클러스터 하나의 최대 삼각형 수(by=clusters일 때)</translation>
    </message>
    <message>
        <source>%1: %2 is given twice.</source>
        <translation>%1: %2이(가) 두 번 주어졌습니다.</translation>
    </message>
    <message>
        <source>The scene would fall into %1 objects; at most %2 are possible. Split it by=clusters with more triangles each.</source>
        <translation>장면이 %1개 물체로 나뉩니다. 최대 %2개까지 가능합니다. by=clusters로 조각마다 삼각형을 더 많이 주어 나누세요.</translation>
    </message>
    <message>
        <source>left plane</source>
        <translation>왼쪽 평면</translation>
    </message>
    <message>
        <source>right plane</source>
        <translation>오른쪽 평면</translation>
    </message>
    <message>
        <source>bottom plane</source>
        <translation>아래쪽 평면</translation>
    </message>
    <message>
        <source>top plane</source>
        <translation>위쪽 평면</translation>
    </message>
    <message>
        <source>near plane</source>
        <translation>가까운 평면</translation>
    </message>
    <message>
        <source>far plane</source>
        <translation>먼 평면</translation>
    </message>
    <message>
        <source>Tested against the %1: even the nearest point of the bounds lies %2 outside, more than the bound of %3.</source>
        <translation>%1 검사: 경계의 가장 가까운 점도 바깥으로 %2 떨어져 있어 허용 한계 %3을(를) 넘습니다.</translation>
    </message>
    <message>
        <source>The strategy leaves the object out: %1.</source>
        <translation>전략이 물체를 제외합니다: %1.</translation>
    </message>
    <message>
        <source>The strategy keeps the object.</source>
        <translation>전략이 물체를 남깁니다.</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box with %2 triangles.</source>
        <translation>&quot;%1&quot; 물체는 삼각형 %2개를 담은 상자 하나로 검사됩니다.</translation>
    </message>
    <message>
        <source>OpenGL draws the triangle: both sides count.</source>
        <translation>OpenGL이 삼각형을 그립니다: 양면을 모두 그립니다.</translation>
    </message>
    <message>
        <source>OpenGL drops the triangle: it is back-facing.</source>
        <translation>OpenGL이 삼각형을 버립니다: 은면입니다.</translation>
    </message>
    <message>
        <source>OpenGL draws the triangle: its front is turned to the eye.</source>
        <translation>OpenGL이 삼각형을 그립니다: 앞면이 눈을 향합니다.</translation>
    </message>
    <message>
        <source>The triangle is given to OpenGL.</source>
        <translation>삼각형이 OpenGL에 전달됩니다.</translation>
    </message>
    <message>
        <source>The triangle is not given to OpenGL.</source>
        <translation>삼각형이 OpenGL에 전달되지 않습니다.</translation>
    </message>
    <message>
        <source>OpenGL lost its context (the graphics driver was reset), which ended the experiment. What was measured before is kept; start it again for the rest.</source>
        <translation>OpenGL 컨텍스트를 잃어(그래픽 드라이버가 초기화됨) 실험이 끝났습니다. 그전에 측정한 것은 남아 있습니다. 나머지는 다시 시작하세요.</translation>
    </message>
    <message>
        <source>OpenGL lost its context (the graphics driver was reset). The scene is being uploaded again; nothing is lost.</source>
        <translation>OpenGL 컨텍스트를 잃었습니다(그래픽 드라이버가 초기화됨). 장면을 다시 올리는 중이며 잃은 것은 없습니다.</translation>
    </message>
    <message>
        <source>OpenGL lost its context, and no new one can be made. What is shown stays: save the session and start Cullscope again.</source>
        <translation>OpenGL 컨텍스트를 잃었고 새로 만들 수 없습니다. 보이는 것은 그대로 있습니다. 세션을 저장하고 Cullscope를 다시 시작하세요.</translation>
    </message>
    <message>
        <source>OpenGL lost its context while this picture was drawn. Take the picture again.</source>
        <translation>이 그림을 그리는 동안 OpenGL 컨텍스트를 잃었습니다. 그림을 다시 찍으세요.</translation>
    </message>
    <message>
        <source>The field of view changed while the path was recorded: all of it has that of its first pose.</source>
        <translation>경로를 기록하는 동안 시야각이 바뀌었습니다. 경로 전체에 첫 자세의 시야각이 쓰입니다.</translation>
    </message>
    <message>
        <source>centroid map</source>
        <translation>무게중심 맵</translation>
    </message>
    <message>
        <source>triangle index map</source>
        <translation>삼각형 색인 맵</translation>
    </message>
    <message>
        <source>The triangle index map of %1 would have more than %2 entries: choose a lower resolution.</source>
        <translation>%1의 삼각형 색인 맵은 항목이 %2개를 넘게 됩니다. 더 낮은 해상도를 고르세요.</translation>
    </message>
    <message>
        <source>%1 was repaired. Dropped faces: degenerate %2, duplicate %3, out of range %4; vertices that are no numbers: %5; other remarks: %6. The Scene panel tells all.</source>
        <translation>%1을(를) 고쳐 읽었습니다. 버린 면: 퇴화 %2, 중복 %3, 범위 밖 %4. 숫자가 아닌 꼭짓점: %5. 그 밖의 참고: %6. 자세한 것은 장면 패널에 있습니다.</translation>
    </message>
    <message>
        <source>%1 cannot be written: pictures of plots are SVG, PDF or PNG. Give the name one of the endings .svg, .pdf and .png.</source>
        <translation>%1을(를) 쓸 수 없습니다: 그래프 그림은 SVG, PDF, PNG입니다. 파일 이름에 .svg, .pdf, .png 중 하나의 확장자를 붙이십시오.</translation>
    </message>
    <message>
        <source>Another experiment is under way: let it end, or cancel it.</source>
        <translation>다른 실험이 진행 중입니다. 끝날 때까지 기다리거나 취소하십시오.</translation>
    </message>
    <message>
        <source>The graphics memory does not hold this strategy&apos;s order of the triangles (%1 bytes): use client vertex arrays or a smaller scene.</source>
        <translation>그래픽 메모리가 이 전략의 삼각형 순서(%1바이트)를 담지 못합니다. 클라이언트 정점 배열을 쓰거나 더 작은 장면을 여십시오.</translation>
    </message>
    <message>
        <source>The numbers of the triangles in this strategy&apos;s order need %1 bytes in one buffer and this OpenGL gives %2: choose a strategy that keeps the mesh&apos;s order, or a part of the scene.</source>
        <translation>이 전략의 순서로 된 삼각형 번호는 한 버퍼에 %1바이트가 필요한데 이 OpenGL은 %2바이트까지 줍니다. 메시의 순서를 지키는 전략이나 장면의 일부를 고르십시오.</translation>
    </message>
    <message>
        <source>The paper&apos;s text has 144,046 faces, its Table 2 has 144,078: 144,046 are measured here, by subdividing the bunny that is installed.</source>
        <translation>논문 본문은 144,046면, 표 2는 144,078면이라고 합니다. 여기서는 설치된 토끼를 세분하여 144,046면을 측정합니다.</translation>
    </message>
    <message>
        <source>The paper compares with drawing every face, back faces too. Against OpenGL&apos;s own back-face culling the gain is smaller: both ratios are given.</source>
        <translation>논문은 뒷면까지 모든 면을 그리는 경우와 비교합니다. OpenGL 자체의 뒷면 제거와 비교하면 이득이 더 작습니다. 두 비율을 모두 보입니다.</translation>
    </message>
    <message>
        <source>The paper counts no lost pixels; here every picture is compared with the exact one.</source>
        <translation>논문은 잃어버린 픽셀을 세지 않습니다. 여기서는 모든 그림을 정확한 그림과 비교합니다.</translation>
    </message>
    <message>
        <source>The paper&apos;s machine was a Xeon at 2.33 GHz with a Quadro FX 5500: compare the ratios, not the frames per second.</source>
        <translation>논문의 컴퓨터는 2.33 GHz Xeon과 Quadro FX 5500입니다. 초당 프레임 수가 아니라 비율을 비교하십시오.</translation>
    </message>
    <message>
        <source>Four windows of 320 × 240 are in Table 3 and in Table 4, with different numbers: 376, 421, 202 against 206, 286, 161 frames per second.</source>
        <translation>320 × 240 창 네 개는 표 3과 표 4에 모두 있으나 수치가 다릅니다: 초당 376, 421, 202 프레임 대 206, 286, 161 프레임.</translation>
    </message>
    <message>
        <source>model</source>
        <translation>모델</translation>
    </message>
    <message>
        <source>memory access map</source>
        <translation>메모리 접근 맵</translation>
    </message>
    <message>
        <source>the three maps</source>
        <translation>세 맵 모두</translation>
    </message>
    <message>
        <source>Sizes of the three structures</source>
        <translation>세 자료구조의 크기</translation>
    </message>
    <message>
        <source>The paper&apos;s formulas (4 floats a face; 2 floats a cell and face; 4 integers a cell) do not give its sizes: its index map would take 74.7 GB.</source>
        <translation>논문의 식(면마다 실수 4개, 셀과 면마다 실수 2개, 셀마다 정수 4개)으로는 논문의 크기가 나오지 않습니다. 색인 맵은 74.7 GB가 됩니다.</translation>
    </message>
    <message>
        <source>In the paper&apos;s table the contents stand in the wrong columns: count, start and reference belong to the memory access map.</source>
        <translation>논문의 표에는 내용이 잘못된 열에 있습니다. 개수, 시작, 참조는 메모리 접근 맵의 것입니다.</translation>
    </message>
    <message>
        <source>All at 360 × 180 cells; 1 MB is 1,000,000 bytes.</source>
        <translation>모두 360 × 180셀입니다. 1 MB는 1,000,000바이트입니다.</translation>
    </message>
    <message>
        <source>structure</source>
        <translation>자료구조</translation>
    </message>
    <message>
        <source>paper: MB</source>
        <translation>논문: MB</translation>
    </message>
    <message>
        <source>paper&apos;s formula: MB</source>
        <translation>논문의 식: MB</translation>
    </message>
    <message>
        <source>here: MB</source>
        <translation>여기: MB</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>바이트</translation>
    </message>
    <message>
        <source>build, ms</source>
        <translation>구축, ms</translation>
    </message>
    <message>
        <source>strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>면</translation>
    </message>
    <message>
        <source>in frustum</source>
        <translation>절두체 안</translation>
    </message>
    <message>
        <source>cases found</source>
        <translation>판정된 경우</translation>
    </message>
    <message>
        <source>views</source>
        <translation>시점</translation>
    </message>
    <message>
        <source>fps max</source>
        <translation>fps 최대</translation>
    </message>
    <message>
        <source>fps min</source>
        <translation>fps 최소</translation>
    </message>
    <message>
        <source>fps mean</source>
        <translation>fps 평균</translation>
    </message>
    <message>
        <source>× all [95 %]</source>
        <translation>× all [95 %]</translation>
    </message>
    <message>
        <source>× backface [95 %]</source>
        <translation>× backface [95 %]</translation>
    </message>
    <message>
        <source>missed px</source>
        <translation>놓친 픽셀</translation>
    </message>
    <message>
        <source>missed ppm</source>
        <translation>놓친 ppm</translation>
    </message>
    <message>
        <source>largest hole, px</source>
        <translation>가장 큰 구멍, 픽셀</translation>
    </message>
    <message>
        <source>paper: fps</source>
        <translation>논문: fps</translation>
    </message>
    <message>
        <source>paper: × all</source>
        <translation>논문: × all</translation>
    </message>
    <message>
        <source>case</source>
        <translation>경우</translation>
    </message>
    <message>
        <source>One window of 320 × 240, the object cut by the frustum</source>
        <translation>320 × 240 창 하나, 절두체가 물체를 자르는 경우</translation>
    </message>
    <message>
        <source>paper: faces</source>
        <translation>논문: 면</translation>
    </message>
    <message>
        <source>Four windows, of two sizes</source>
        <translation>창 네 개, 두 가지 크기</translation>
    </message>
    <message>
        <source>size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Four and eight windows of 320 × 240</source>
        <translation>320 × 240 창 네 개와 여덟 개</translation>
    </message>
    <message>
        <source>windows</source>
        <translation>창</translation>
    </message>
    <message>
        <source>One window of 640 × 480, the object inside the frustum</source>
        <translation>640 × 480 창 하나, 물체가 절두체 안에 있는 경우</translation>
    </message>
    <message>
        <source>upload</source>
        <translation>업로드</translation>
    </message>
    <message>
        <source>paper: fps max</source>
        <translation>논문: fps 최대</translation>
    </message>
    <message>
        <source>paper: fps min</source>
        <translation>논문: fps 최소</translation>
    </message>
    <message>
        <source>paper: fps mean</source>
        <translation>논문: fps 평균</translation>
    </message>
    <message>
        <source>The paper has &quot;10 or more&quot; views and does not say which: here 12, evenly around the object at three radii, all of it in view. spherical-horizon is not the paper&apos;s: it is the same idea made right.</source>
        <translation>논문은 시점이 &quot;10개 이상&quot;이라고만 하고 어느 것인지 말하지 않습니다. 여기서는 반지름의 세 배 거리에서 물체 둘레에 고르게 놓인 12개이며 물체 전체가 보입니다. spherical-horizon은 논문의 것이 아니라 같은 생각을 바로잡은 것입니다.</translation>
    </message>
    <message>
        <source>There is no colouring of the index map &quot;%1&quot;. Known: %2.</source>
        <translation>색인 맵의 색칠 방식 &quot;%1&quot;은(는) 없습니다. 있는 것: %2.</translation>
    </message>
    <message>
        <source>There is no experiment &quot;%1&quot;. Known: %2.</source>
        <translation>&quot;%1&quot; 실험은 없습니다. 있는 것: %2.</translation>
    </message>
    <message>
        <source>12 close views with a pole of the spherical map in them, 9.4 % of the faces in the frustum</source>
        <translation>구면 맵의 극이 보이는 가까운 시점 12개, 면의 9.4 %가 절두체 안</translation>
    </message>
    <message>
        <source>12 close views of one clump of the spherical map, 11.4 % of the faces in the frustum</source>
        <translation>구면 맵의 한 덩어리를 보는 가까운 시점 12개, 면의 11.4 %가 절두체 안</translation>
    </message>
    <message>
        <source>12 close views of a clump that the map&apos;s seam splits, 18.3 % of the faces in the frustum</source>
        <translation>구면 맵의 이음선이 나누는 덩어리를 보는 가까운 시점 12개, 면의 18.3 %가 절두체 안</translation>
    </message>
    <message>
        <source>Width of a contour band, seen from the centre.</source>
        <translation>중심에서 본 등고선 띠의 폭.</translation>
    </message>
    <message>
        <source>Sectors into which a contour band is divided.</source>
        <translation>등고선 띠를 나누는 부채꼴의 수.</translation>
    </message>
    <message>
        <source>draw list</source>
        <translation>그리기 목록</translation>
    </message>
    <message>
        <source>maps and bands</source>
        <translation>맵과 띠</translation>
    </message>
    <message>
        <source>Spherical coordinates</source>
        <translation>구좌표</translation>
    </message>
    <message>
        <source>Looks up on a map of directions what four corner rays enclose; seen whole, compares contour bands by S. As published, with its losses.</source>
        <translation>네 모서리 광선이 둘러싼 것을 방향의 맵에서 찾고, 전체가 보이면 등고선 띠를 S로 비교합니다. 논문 그대로이며 손실도 그대로입니다.</translation>
    </message>
    <message>
        <source>straight on the map, so that the extremes are the hits&apos;</source>
        <translation>맵에서 직선으로. 영역의 끝이 교차점과 같습니다</translation>
    </message>
    <message>
        <source>by great circles, whose extremes may lie between the hits</source>
        <translation>대원으로. 끝이 교차점 사이에 있을 수 있습니다</translation>
    </message>
    <message>
        <source>Spherical coordinates, exact horizon</source>
        <translation>구좌표, 정확한 지평선</translation>
    </message>
    <message>
        <source>Leaves out cells whose slope lies below the horizon of the surface in front of them: loses nothing of star-shaped objects.</source>
        <translation>앞쪽 표면의 지평선보다 기울기가 낮은 셀을 제외합니다. 별 모양 물체에서는 아무것도 잃지 않습니다.</translation>
    </message>
    <message>
        <source>cut by the frustum</source>
        <translation>절두체에 잘림</translation>
    </message>
    <message>
        <source>inside the frustum</source>
        <translation>절두체 안</translation>
    </message>
    <message>
        <source>around the eye</source>
        <translation>눈을 둘러쌈</translation>
    </message>
    <message>
        <source>The strategy draws the object in part; the rest is left out: %1.</source>
        <translation>전략이 물체의 일부를 그립니다. 나머지는 제외합니다: %1.</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one bounding sphere with %2 triangles.</source>
        <translation>&quot;%1&quot; 물체는 삼각형 %2개가 든 경계구 하나로 검사합니다.</translation>
    </message>
    <message>
        <source>Its centroid lies in the map&apos;s row %1, column %2: zenith angle %3° to %4°, azimuth %5° to %6°.</source>
        <translation>무게중심이 맵의 행 %1, 열 %2에 있습니다: 고도각 %3°–%4°, 방위각 %5°–%6°.</translation>
    </message>
    <message>
        <source>The cell lies in the visible region&apos;s boxes (case %1).</source>
        <translation>셀이 가시 영역의 상자 안에 있습니다(경우 %1).</translation>
    </message>
    <message>
        <source>The cell lies outside the visible region&apos;s boxes (case %1).</source>
        <translation>셀이 가시 영역의 상자 밖에 있습니다(경우 %1).</translation>
    </message>
    <message>
        <source>The object&apos;s bounding sphere: %1.</source>
        <translation>물체의 경계구: %1.</translation>
    </message>
    <message>
        <source>half a hollow sphere, open towards z: closed, hides its inside from its outside</source>
        <translation>속이 빈 반구, z 쪽이 열림: 닫혀 있고, 안쪽이 바깥쪽에서 가려집니다</translation>
    </message>
    <message>
        <source>Rows of the maps, 2 at least; columns are twice as many. A mesh has no more cells than triangles. 0: as many cells a triangle as in the paper.</source>
        <translation>맵의 행 수, 2 이상. 열은 그 두 배입니다. 메시의 셀은 삼각형보다 많지 않습니다. 0: 논문과 같은 삼각형당 셀 수.</translation>
    </message>
    <message>
        <source>order of the triangles</source>
        <translation>삼각형의 순서</translation>
    </message>
    <message>
        <source>bounds of the cells</source>
        <translation>셀의 경계</translation>
    </message>
    <message>
        <source>There is no layout of the map &quot;%1&quot;. Known: %2.</source>
        <translation>&quot;%1&quot;이라는 맵 배치는 없습니다. 있는 것: %2.</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>채워져 있음</translation>
    </message>
    <message>
        <source>the mesh is not closed or not consistently oriented</source>
        <translation>메시가 닫혀 있지 않거나 방향이 일관되지 않습니다</translation>
    </message>
    <message>
        <source>the centre of the bounding sphere lies outside the solid</source>
        <translation>경계구의 중심이 입체 밖에 있습니다</translation>
    </message>
    <message>
        <source>the surface comes too near to the centre of the bounding sphere</source>
        <translation>표면이 경계구의 중심에 너무 가깝습니다</translation>
    </message>
    <message>
        <source>meshes of more than five million triangles are not asked whether they are closed</source>
        <translation>삼각형이 5백만 개를 넘는 메시는 닫혀 있는지 검사하지 않습니다</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>셀</translation>
    </message>
    <message>
        <source>cells against the frustum</source>
        <translation>절두체에 대한 셀 검사</translation>
    </message>
    <message>
        <source>normal cones</source>
        <translation>법선 원뿔</translation>
    </message>
    <message>
        <source>horizon of the kernel</source>
        <translation>커널의 지평선</translation>
    </message>
    <message>
        <source>groups of objects</source>
        <translation>물체 그룹</translation>
    </message>
    <message>
        <source>Spherical coordinates, lossless</source>
        <translation>구좌표, 무손실</translation>
    </message>
    <message>
        <source>Tests the cells of a map of directions, from large to small, against the frustum, by normal cones and by the horizon of the solid&apos;s inner kernel: loses nothing on any mesh.</source>
        <translation>방향 맵의 셀을 큰 것에서 작은 것으로 절두체, 법선 원뿔, 입체 내부 커널의 지평선으로 검사합니다. 어떤 메시에서도 아무것도 잃지 않습니다.</translation>
    </message>
    <message>
        <source>How directions are laid out on the map.</source>
        <translation>방향을 맵에 펼치는 방식.</translation>
    </message>
    <message>
        <source>an octahedron unfolded: no poles, no trigonometry</source>
        <translation>펼친 팔면체: 극도 삼각함수도 없음</translation>
    </message>
    <message>
        <source>rows of zenith angle and columns of azimuth, as in the paper</source>
        <translation>논문처럼 고도각의 행과 방위각의 열</translation>
    </message>
    <message>
        <source>How often the map is quartered: 2^level cells a side; 0: down to some four dozen triangles a cell. An object of fewer than a thousand is one cell.</source>
        <translation>맵을 네 등분하는 횟수: 한 변에 2^level개의 셀. 0: 셀마다 삼각형이 약 48개가 될 때까지. 천 개 미만인 물체는 셀 하나입니다.</translation>
    </message>
    <message>
        <source>Whether cells whose triangles all face away are left out (where only front sides are drawn).</source>
        <translation>모든 삼각형이 등을 돌린 셀을 제외할지 여부(앞면만 그릴 때).</translation>
    </message>
    <message>
        <source>Whether cells behind the solid&apos;s inner kernel are left out (where the mesh is closed).</source>
        <translation>입체의 내부 커널 뒤에 있는 셀을 제외할지 여부(메시가 닫혀 있을 때).</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: it reaches over the edge of the frustum, so that its objects were tested one by one.</source>
        <translation>물체 %1개의 그룹에 속하며, 그룹의 상자를 먼저 검사합니다: 절두체의 경계에 걸쳐 있어 물체를 하나씩 검사합니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: outside the %2.</source>
        <translation>물체 %1개의 그룹에 속하며, 그룹의 상자를 먼저 검사합니다: %2 밖에 있습니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: wholly inside the frustum, so that nothing of it was tested again.</source>
        <translation>물체 %1개의 그룹에 속하며, 그룹의 상자를 먼저 검사합니다: 절두체 안에 완전히 들어 있어 그 안의 어떤 것도 다시 검사하지 않습니다.</translation>
    </message>
    <message>
        <source>No test left the cell out: its triangles are drawn.</source>
        <translation>어떤 검사도 이 셀을 제외하지 않았으므로 삼각형을 그립니다.</translation>
    </message>
    <message>
        <source>All normals of the cell lie in a cone that is turned away from the eye, by more than the picture&apos;s snapping could undo.</source>
        <translation>셀의 모든 법선이 눈을 등진 원뿔 안에 있으며, 그 정도가 그림의 격자 맞춤으로 뒤집힐 수 있는 것보다 큽니다.</translation>
    </message>
    <message>
        <source>All sight lines to the cell pass through the solid&apos;s inner kernel first.</source>
        <translation>셀에 이르는 모든 시선이 먼저 입체의 내부 커널을 지납니다.</translation>
    </message>
    <message>
        <source>The box around the cell&apos;s triangles lies outside one plane of the frustum.</source>
        <translation>셀의 삼각형을 둘러싼 상자가 절두체의 한 평면 밖에 있습니다.</translation>
    </message>
    <message>
        <source>The kernel&apos;s horizon is not used: %1.</source>
        <translation>커널의 지평선을 쓰지 않습니다: %1.</translation>
    </message>
    <message>
        <source>The object has too few triangles to be divided: it is one cell.</source>
        <translation>물체의 삼각형이 적어 나누지 않습니다: 셀 하나입니다.</translation>
    </message>
    <message>
        <source>The walk over the map ended at a cell of level %1, which holds %2 triangles.</source>
        <translation>맵의 순회가 레벨 %1의 셀에서 끝났으며, 이 셀에는 삼각형이 %2개 있습니다.</translation>
    </message>
    <message>
        <source>The strategy draws the object in part; %1 of its triangles are left out: %2.</source>
        <translation>전략이 물체의 일부를 그립니다. 삼각형 %1개는 제외합니다: %2.</translation>
    </message>
    <message>
        <source>OpenGL&apos;s selection mode was removed from the core profile, and this OpenGL gives no compatibility profile: ask by occlusion queries.</source>
        <translation>OpenGL의 선택 모드는 코어 프로필에서 없어졌고 이 OpenGL에는 호환 프로필이 없습니다. 차폐 질의로 물어보십시오.</translation>
    </message>
    <message>
        <source>The paper does not give its 40 viewpoints: here a walk on which the frustum leaves out about as much, 79 % on average.</source>
        <translation>논문에는 40개 시점이 나와 있지 않습니다. 여기서는 절두체가 제외하는 몫이 논문과 거의 같은(평균 79 %) 경로를 걷습니다.</translation>
    </message>
    <message>
        <source>Two-sided rows (solid lines) draw both sides of every face, as the paper does: compare them with all. Front rows (dashed) leave back faces to OpenGL: compare them with backface.</source>
        <translation>양면인 행(실선)은 논문처럼 모든 면의 앞뒤를 그리므로 all과 비교하십시오. 앞면인 행(파선)은 뒷면을 OpenGL에 맡기므로 backface와 비교하십시오.</translation>
    </message>
    <message>
        <source>The paper&apos;s method is frustum-select; frustum tests the same boxes on the processor. The paper&apos;s largest speed-up is its 33 fps over its 0.83.</source>
        <translation>논문의 방법은 frustum-select이고, frustum은 같은 상자를 프로세서에서 검사합니다. 논문의 최대 배속은 33 fps를 0.83으로 나눈 값입니다.</translation>
    </message>
    <message>
        <source>Culling saves work on triangles, not on pixels: where pixels take much of the frame, as in a software OpenGL, the gain is small.</source>
        <translation>컬링은 삼각형에 드는 일을 줄일 뿐 픽셀에 드는 일은 줄이지 않습니다. 소프트웨어 OpenGL처럼 픽셀이 프레임의 큰 몫을 차지하면 이득이 작습니다.</translation>
    </message>
    <message>
        <source>Where the walk leads through a bunny, a picture of both sides shows its inside, which backface does not draw: those are its missed pixels.</source>
        <translation>경로가 토끼를 뚫고 지나는 곳에서는 양면 그림에 그 안쪽이 보이지만 backface는 그것을 그리지 않습니다. 그것이 backface가 놓친 픽셀입니다.</translation>
    </message>
    <message>
        <source>The paper&apos;s machine was a Pentium III at 866 MHz with a GeForce3 Ti 200: compare the ratios, not the frames per second. The paper counts no lost pixels.</source>
        <translation>논문의 기계는 GeForce3 Ti 200을 단 866 MHz Pentium III였습니다. 초당 프레임 수가 아니라 비율을 비교하십시오. 논문은 잃은 픽셀을 세지 않습니다.</translation>
    </message>
    <message>
        <source>sides drawn</source>
        <translation>그리는 면</translation>
    </message>
    <message>
        <source>fps, all views</source>
        <translation>fps, 모든 시점</translation>
    </message>
    <message>
        <source>paper: × all, max</source>
        <translation>논문: × all, 최대</translation>
    </message>
    <message>
        <source>× all, best view [95 %]</source>
        <translation>× all, 최대 시점 [95 %]</translation>
    </message>
    <message>
        <source>paper: culled, %</source>
        <translation>논문: 제외, %</translation>
    </message>
    <message>
        <source>culled, %</source>
        <translation>제외, %</translation>
    </message>
    <message>
        <source>culled max, %</source>
        <translation>최대 제외, %</translation>
    </message>
    <message>
        <source>paper: culling, % of the frame</source>
        <translation>논문: 컬링, 프레임의 %</translation>
    </message>
    <message>
        <source>culling, % of the frame</source>
        <translation>컬링, 프레임의 %</translation>
    </message>
    <message>
        <source>Frames per second by viewpoint</source>
        <translation>시점별 초당 프레임 수</translation>
    </message>
    <message>
        <source>viewpoint</source>
        <translation>시점</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>초당 프레임 수</translation>
    </message>
    <message>
        <source>paper, culled, at most:</source>
        <translation>논문, 컬링, 최대:</translation>
    </message>
    <message>
        <source>paper, culled, mean:</source>
        <translation>논문, 컬링, 평균:</translation>
    </message>
    <message>
        <source>paper, every bunny drawn:</source>
        <translation>논문, 모두 그림:</translation>
    </message>
    <message>
        <source>400 bunnies from 40 viewpoints: view-frustum culling</source>
        <translation>40개 시점에서 본 토끼 400마리: 뷰 절두체 컬링</translation>
    </message>
    <message>
        <source>front</source>
        <translation>앞면</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>양면</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not of the form key=value.</source>
        <translation>&quot;%1&quot;은(는) key=value 형식이 아닙니다.</translation>
    </message>
    <message>
        <source>The strategy &quot;%1&quot; has no parameters.</source>
        <translation>전략 &quot;%1&quot;에는 매개변수가 없습니다.</translation>
    </message>
    <message>
        <source>boxes</source>
        <translation>상자</translation>
    </message>
    <message>
        <source>asking OpenGL</source>
        <translation>OpenGL에 묻기</translation>
    </message>
    <message>
        <source>View-frustum culling by selection</source>
        <translation>선택 모드 절두체 컬링</translation>
    </message>
    <message>
        <source>Draws the objects&apos; boxes in OpenGL&apos;s selection mode: the hit records name the objects in view.</source>
        <translation>물체의 상자를 OpenGL 선택 모드로 그립니다. 히트 레코드가 시야 안의 물체를 알려 줍니다.</translation>
    </message>
    <message>
        <source>Words of the hit buffer to begin with, four an object in view: one that overflows is doubled, and the boxes are drawn again.</source>
        <translation>처음 히트 버퍼의 워드 수(시야 안의 물체마다 넷). 넘치면 두 배로 늘려 상자를 다시 그립니다.</translation>
    </message>
    <message>
        <source>View-frustum culling by queries</source>
        <translation>질의 절두체 컬링</translation>
    </message>
    <message>
        <source>Draws the objects&apos; boxes unseen, with an occlusion query each: those that cover a sample are in view.</source>
        <translation>물체의 상자를 보이지 않게 그리고 상자마다 차폐 질의를 합니다. 샘플을 덮는 것이 시야 안에 있습니다.</translation>
    </message>
    <message>
        <source>the mesh&apos;s own box, turned with the object, by its corner farthest inside</source>
        <translation>물체와 함께 돌린 메시 자체의 상자를 가장 안쪽 꼭짓점으로</translation>
    </message>
    <message>
        <source>View-frustum culling by groups</source>
        <translation>그룹별 절두체 컬링</translation>
    </message>
    <message>
        <source>Leaves out whole groups of objects by an octree over their boxes, and draws the rest nearest first.</source>
        <translation>물체 상자의 옥트리로 그룹을 통째로 제외하고 나머지를 가까운 것부터 그립니다.</translation>
    </message>
    <message>
        <source>Whether what several planes cut is tested by separating axes too, which leaves out what lies beside the frustum&apos;s edges.</source>
        <translation>여러 평면이 자르는 것을 분리축으로도 검사할지 여부. 절두체 모서리 옆에 있는 것까지 제외합니다.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; draws in OpenGL&apos;s selection mode, which was removed from the core profile, and this OpenGL (%2) gives no compatibility profile: &quot;frustum-query&quot; asks the same without it.</source>
        <translation>&quot;%1&quot;은(는) OpenGL 선택 모드로 그리는데, 이 모드는 코어 프로필에서 없어졌고 이 OpenGL(%2)에는 호환 프로필이 없습니다. &quot;frustum-query&quot;가 그것 없이 같은 것을 묻습니다.</translation>
    </message>
    <message>
        <source>This strategy asks OpenGL what is visible, and there is no OpenGL context here.</source>
        <translation>이 전략은 무엇이 보이는지 OpenGL에 묻는데 여기에는 OpenGL 컨텍스트가 없습니다.</translation>
    </message>
    <message>
        <source>No single plane has the bounds outside, but an axis parts them from the frustum: they lie beside one of its edges or corners.</source>
        <translation>어느 한 평면도 경계 전체를 바깥에 두지 않지만 한 축이 경계를 절두체와 갈라놓습니다. 절두체의 모서리나 꼭짓점 옆에 있습니다.</translation>
    </message>
    <message>
        <source>The box reaches the near rectangle of the view: it is visible without asking.</source>
        <translation>상자가 시야의 근평면 사각형에 닿습니다. 묻지 않아도 보이는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: nothing of it was hit.</source>
        <translation>%1만큼 키운 상자를 OpenGL에 물었습니다. 걸린 것이 없습니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: it was hit.</source>
        <translation>%1만큼 키운 상자를 OpenGL에 물었습니다. 걸렸습니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: an axis parts it from the frustum.</source>
        <translation>물체 %1개의 그룹에 있으며 그 상자를 먼저 검사했습니다. 한 축이 상자를 절두체와 갈라놓습니다.</translation>
    </message>
    <message>
        <source>Tested against the %1: all of the bounds lie inside, the farthest point by %2.</source>
        <translation>%1 검사: 경계 전체가 안쪽에 있으며, 가장 깊은 점은 %2 안쪽입니다.</translation>
    </message>
    <message>
        <source>Tested against the %1: the bounds lie %2 outside, within the bound of %3, and count as inside.</source>
        <translation>%1 검사: 경계가 바깥으로 %2 벗어나 있지만 허용 한계 %3 이내이므로 안쪽으로 봅니다.</translation>
    </message>
    <message>
        <source>Tested against the %1: the bounds reach %2 to the inside.</source>
        <translation>%1 검사: 경계가 안쪽으로 %2까지 들어옵니다.</translation>
    </message>
    <message>
        <source>Contour bands</source>
        <translation>등고선 띠</translation>
    </message>
    <message>
        <source>Inner kernel and horizon</source>
        <translation>내부 커널과 지평선</translation>
    </message>
    <message>
        <source>&amp;Contour bands</source>
        <translation>등고선 띠(&amp;C)</translation>
    </message>
    <message>
        <source>Inner &amp;kernel and horizon</source>
        <translation>내부 커널과 지평선(&amp;K)</translation>
    </message>
    <message>
        <source>Show the solid&apos;s inner kernel in the active view, and its outline as the culling camera sees it: what lies behind it is left out by the lossless spherical strategy</source>
        <translation>활성 뷰에 입체의 내부 커널과 컬링 카메라가 본 그 윤곽을 표시합니다. 그 뒤에 있는 것은 무손실 구좌표 전략이 제외합니다</translation>
    </message>
    <message>
        <source>A strategy made a picture of %1 × %2 pixels for a view of %3 × %4.</source>
        <translation>전략이 %3 × %4 보기에 대해 %1 × %2 픽셀의 그림을 만들었습니다.</translation>
    </message>
    <message>
        <source>Tested by separating axes, for several planes cut the bounds: none parts them from the frustum.</source>
        <translation>여러 평면이 경계를 자르므로 분리 축으로 검사: 경계와 절두체를 가르는 축이 없습니다.</translation>
    </message>
    <message>
        <source>A few views with little in them raise the means of the frames per second and of the views&apos; ratios; &quot;fps, all views&quot; and &quot;× all&quot; are of the total times.</source>
        <translation>보이는 것이 적은 몇 시점이 초당 프레임 수와 시점별 비율의 평균을 끌어올립니다. &quot;fps, 모든 시점&quot;과 &quot;× all&quot;은 총시간으로 구한 값입니다.</translation>
    </message>
    <message>
        <source>mean of the views&apos; × all [95 %]</source>
        <translation>시점별 × all의 평균 [95 %]</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>매개변수</translation>
    </message>
    <message>
        <source>value</source>
        <translation>값</translation>
    </message>
    <message>
        <source>Speed against loss</source>
        <translation>속도와 손실</translation>
    </message>
    <message>
        <source>missed pixels, share</source>
        <translation>놓친 픽셀의 비율</translation>
    </message>
    <message>
        <source>for each object</source>
        <translation>각 물체에 대해</translation>
    </message>
    <message>
        <source>box at near rectangle: in view</source>
        <translation>상자가 가까운 사각형에 닿으면: 보임</translation>
    </message>
    <message>
        <source>outside near or far: not in view</source>
        <translation>가까운 평면 앞이나 먼 평면 너머면: 안 보임</translation>
    </message>
    <message>
        <source>else in view if OpenGL hit it</source>
        <translation>아니면 OpenGL이 상자를 맞혔을 때 보임</translation>
    </message>
    <message>
        <source>in view: draw it</source>
        <translation>보이면: 그림</translation>
    </message>
    <message>
        <source>not in view: leave it out</source>
        <translation>안 보이면: 제외</translation>
    </message>
    <message>
        <source>draw grown boxes for selection</source>
        <translation>키운 상자를 선택 모드로 그림</translation>
    </message>
    <message>
        <source>draw grown boxes, a query each</source>
        <translation>키운 상자를 질의 하나씩으로 보이지 않게 그림</translation>
    </message>
    <message>
        <source>visit(group, planes that may cut it)</source>
        <translation>방문(그룹, 자를 수 있는 평면들)</translation>
    </message>
    <message>
        <source>test its box against these planes</source>
        <translation>상자를 이 평면들로 검사</translation>
    </message>
    <message>
        <source>several cut it: test axes too</source>
        <translation>여러 평면이 자르면: 분리하는 축을 찾음</translation>
    </message>
    <message>
        <source>outside: leave all its objects out</source>
        <translation>밖이면: 물체를 모두 제외</translation>
    </message>
    <message>
        <source>inside: keep all its objects</source>
        <translation>모든 평면의 안이면: 물체를 모두 남김</translation>
    </message>
    <message>
        <source>else visit(parts, cutting planes)</source>
        <translation>아니면 방문(각 부분, 자르는 평면들)</translation>
    </message>
    <message>
        <source>no parts: test each object too</source>
        <translation>부분이 없으면: 물체를 하나씩 같은 방법으로 검사</translation>
    </message>
    <message>
        <source>outside: leave the object out</source>
        <translation>밖이면: 물체를 제외</translation>
    </message>
    <message>
        <source>draw the objects kept, nearest first</source>
        <translation>남은 물체를 가까운 것부터 그림</translation>
    </message>
    <message>
        <source>Objects by the plane that rejected them</source>
        <translation>탈락시킨 평면별 물체 수</translation>
    </message>
    <message>
        <source>no single plane</source>
        <translation>단일 평면 없음</translation>
    </message>
    <message>
        <source>Size by contour band</source>
        <translation>등고선 띠별 크기</translation>
    </message>
    <message>
        <source>Beyond α = %1 nothing is drawn.</source>
        <translation>α = %1 너머로는 아무것도 그리지 않습니다.</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>기울기</translation>
    </message>
    <message>
        <source>S, mesh units</source>
        <translation>S, 메시 단위</translation>
    </message>
    <message>
        <source>Upwards: %1; to the right: angle α from the axis to the eye; sector %2</source>
        <translation>위로: %1, 오른쪽으로: 눈을 향한 축으로부터의 각 α, 부채꼴 %2</translation>
    </message>
    <message>
        <source>Upwards: %1, the largest of all sectors; to the right: angle α from the axis to the eye. Each sector is compared by itself; a band of two colours is drawn in some sectors and hidden in others.</source>
        <translation>위로: %1(전체 부채꼴 중 최댓값), 오른쪽으로: 눈을 향한 축으로부터의 각 α. 각 부채꼴은 따로 비교되며, 두 색으로 나뉜 띠는 일부 부채꼴에서는 그려지고 다른 부채꼴에서는 가려집니다.</translation>
    </message>
    <message>
        <source>α %1 to %2</source>
        <translation>α %1~%2</translation>
    </message>
    <message>
        <source>drawn: %1 %2</source>
        <translation>그려짐: %1 %2</translation>
    </message>
    <message>
        <source>hidden: %1 %2</source>
        <translation>가려짐: %1 %2</translation>
    </message>
    <message>
        <source>Nothing lies here.</source>
        <translation>여기에는 아무것도 없습니다.</translation>
    </message>
    <message>
        <source>largest nearer: %1</source>
        <translation>더 가까운 곳의 최댓값: %1</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>그려짐</translation>
    </message>
    <message>
        <source>drawn in some sectors</source>
        <translation>일부 부채꼴에서 그려짐</translation>
    </message>
    <message>
        <source>hidden in some sectors</source>
        <translation>일부 부채꼴에서 가려짐</translation>
    </message>
    <message>
        <source>largest nearer</source>
        <translation>더 가까운 곳의 최댓값</translation>
    </message>
    <message>
        <source>Se&amp;ctor:</source>
        <translation>부채꼴(&amp;C):</translation>
    </message>
    <message>
        <source>Sectors divide the bands by the angle β about the axis to the eye; each one is tested by itself. Until you choose one, it is the one that is drawn farthest.</source>
        <translation>부채꼴은 눈을 향한 축 둘레의 각 β로 띠를 나누며, 각각 따로 검사됩니다. 직접 고르기 전에는 가장 멀리까지 그려지는 부채꼴이 표시됩니다.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>전체</translation>
    </message>
    <message>
        <source>β %1 to %2</source>
        <translation>β %1~%2</translation>
    </message>
    <message>
        <source>%1 is %2: its bands are not tested. Bring all of it into the picture to see them.</source>
        <translation>%1: %2, 띠를 검사하지 않습니다. 띠를 보려면 물체 전체를 화면에 담으십시오.</translation>
    </message>
    <message>
        <source>Entries a cell</source>
        <translation>셀당 항목 수</translation>
    </message>
    <message>
        <source>triangles a cell, logarithmic</source>
        <translation>셀당 삼각형 수, 로그 눈금</translation>
    </message>
    <message>
        <source>Farthest R</source>
        <translation>가장 먼 R</translation>
    </message>
    <message>
        <source>farthest R, mesh units</source>
        <translation>가장 먼 R, 메시 단위</translation>
    </message>
    <message>
        <source>State</source>
        <translation>상태</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>레벨</translation>
    </message>
    <message>
        <source>level where the walk ended</source>
        <translation>순회가 끝난 레벨</translation>
    </message>
    <message>
        <source>Kernel</source>
        <translation>커널</translation>
    </message>
    <message>
        <source>R of the kernel, of the sphere&apos;s</source>
        <translation>커널의 R, 구의 R에 대한 비율</translation>
    </message>
    <message>
        <source>Triangle index map</source>
        <translation>삼각형 색인 맵</translation>
    </message>
    <message>
        <source>Case 1: all azimuths, one range in all</source>
        <translation>경우 1: 모든 방위각, 전체가 한 구간</translation>
    </message>
    <message>
        <source>Case 2: one clump, one range a row</source>
        <translation>경우 2: 한 덩어리, 행마다 한 구간</translation>
    </message>
    <message>
        <source>Case 3: split by the seam, two ranges a row</source>
        <translation>경우 3: 이음선으로 갈라짐, 행마다 두 구간</translation>
    </message>
    <message>
        <source>bottom left</source>
        <translation>왼쪽 아래</translation>
    </message>
    <message>
        <source>bottom right</source>
        <translation>오른쪽 아래</translation>
    </message>
    <message>
        <source>top right</source>
        <translation>오른쪽 위</translation>
    </message>
    <message>
        <source>top left</source>
        <translation>왼쪽 위</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>사용 안 함</translation>
    </message>
    <message>
        <source>No kernel: the horizon is switched off, or the mesh is too small for one</source>
        <translation>커널 없음: 지평선이 꺼져 있거나 메시가 너무 작습니다</translation>
    </message>
    <message>
        <source>No kernel: %1</source>
        <translation>커널 없음: %1</translation>
    </message>
    <message>
        <source>Kernel filled to R %1 at least</source>
        <translation>커널은 적어도 R %1까지 차 있음</translation>
    </message>
    <message>
        <source>Horizon not used: the eye is inside the bounding sphere</source>
        <translation>지평선 사용 안 함: 눈이 경계구 안에 있음</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2 of %3): %4</source>
        <translation>%1 (%2/%3): %4</translation>
    </message>
    <message>
        <source>Nothing of it is drawn.</source>
        <translation>아무것도 그리지 않습니다.</translation>
    </message>
    <message>
        <source>Bands of %1; drawn: %2 of %3 triangles</source>
        <translation>띠 폭 %1, 그린 삼각형: %2/%3</translation>
    </message>
    <message>
        <source>Everything of it is drawn.</source>
        <translation>모두 그립니다.</translation>
    </message>
    <message>
        <source>Drawn: %1 of %2 triangles</source>
        <translation>그린 삼각형: %1/%2</translation>
    </message>
    <message>
        <source>Culled: frustum %1 · cones %2 · horizon %3</source>
        <translation>제거: 절두체 %1 · 법선 원뿔 %2 · 지평선 %3</translation>
    </message>
    <message>
        <source>Row %1, column %2</source>
        <translation>행 %1, 열 %2</translation>
    </message>
    <message>
        <source>θ %1 to %2, φ %3 to %4</source>
        <translation>θ %1~%2, φ %3~%4</translation>
    </message>
    <message>
        <source>Triangles in it: %1, of which it owns %2</source>
        <translation>걸친 삼각형: %1, 그중 속한 것: %2</translation>
    </message>
    <message>
        <source>R %1 to %2 mesh units</source>
        <translation>R %1~%2 메시 단위</translation>
    </message>
    <message>
        <source>Quadtree: level %1, triangles: %2, %3</source>
        <translation>사분 트리: 레벨 %1, 삼각형: %2, %3</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: confirmed on triangle %3.</source>
        <translation>모서리 광선 %1, %2: 삼각형 %3에서 교차가 확인되었습니다.</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: passes the object by; its place is where it enters the sphere.</source>
        <translation>모서리 광선 %1, %2: 물체를 지나칩니다. 구에 들어가는 점을 씁니다.</translation>
    </message>
    <message>
        <source>Corner ray %1, %2: misses the sphere; its place is the sphere&apos;s nearest point.</source>
        <translation>모서리 광선 %1, %2: 구를 빗나갑니다. 구에서 가장 가까운 점을 씁니다.</translation>
    </message>
    <message>
        <source>sector %1</source>
        <translation>부채꼴 %1</translation>
    </message>
    <message>
        <source>visible region</source>
        <translation>가시 영역</translation>
    </message>
    <message>
        <source>corner: hit</source>
        <translation>모서리: 교차</translation>
    </message>
    <message>
        <source>corner: miss, nearest point</source>
        <translation>모서리: 빗나감, 최근접점</translation>
    </message>
    <message>
        <source>contours of α every %1</source>
        <translation>α의 등고선, %1 간격</translation>
    </message>
    <message>
        <source>nearest to the eye</source>
        <translation>눈에 가장 가까움</translation>
    </message>
    <message>
        <source>opposite</source>
        <translation>반대쪽</translation>
    </message>
    <message>
        <source>cell of the quadtree</source>
        <translation>사분 트리의 셀</translation>
    </message>
    <message>
        <source>its sphere against six planes</source>
        <translation>구를 여섯 평면으로 검사</translation>
    </message>
    <message>
        <source>outside: leave it out</source>
        <translation>밖이면: 제외</translation>
    </message>
    <message>
        <source>around the eye, flat: draw all</source>
        <translation>눈을 둘러싸거나 납작하면: 모두 그림</translation>
    </message>
    <message>
        <source>cut by near, flat, small: draw all</source>
        <translation>가까운 평면에 잘림, 납작함, 작음: 모두 그림</translation>
    </message>
    <message>
        <source>else draw cells above the horizon</source>
        <translation>아니면 앞쪽 지평선 위의 셀을 그림</translation>
    </message>
    <message>
        <source>test groups, objects by planes</source>
        <translation>그룹을, 다음에 물체를 평면으로 검사</translation>
    </message>
    <message>
        <source>outside: leave it all out</source>
        <translation>밖이면: 그룹이나 물체를 제외</translation>
    </message>
    <message>
        <source>each other object (small: draw)</source>
        <translation>남은 각 물체에 대해 (작으면: 그림)</translation>
    </message>
    <message>
        <source>sphere outside: leave it out</source>
        <translation>구가 한 평면 밖이면: 제외</translation>
    </message>
    <message>
        <source>box outside: leave it out</source>
        <translation>상자가 한 평면 밖이면: 제외</translation>
    </message>
    <message>
        <source>faces away: leave it out</source>
        <translation>법선이 모두 등을 돌렸으면: 제외</translation>
    </message>
    <message>
        <source>behind horizon: leave it out</source>
        <translation>커널의 지평선 뒤면: 제외</translation>
    </message>
    <message>
        <source>no test open, leaf, gap: draw</source>
        <translation>남은 검사나 부분이 없거나 틈이면: 그림</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>띠</translation>
    </message>
    <message>
        <source>Triangles by the test that left them out</source>
        <translation>제외한 검사별 삼각형 수</translation>
    </message>
    <message>
        <source>planes of the frustum</source>
        <translation>절두체의 평면</translation>
    </message>
    <message>
        <source>distances</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one sphere with %2 triangles.</source>
        <translation>&quot;%1&quot; 물체는 삼각형 %2개를 담은 구 하나로 검사됩니다.</translation>
    </message>
    <message>
        <source>Its sphere begins %1 from the eye, beyond the distance of %2: so far away it counts as too small.</source>
        <translation>구가 눈에서 %1 떨어진 곳에서 시작하여 거리 %2를 넘습니다. 그렇게 멀면 너무 작은 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its sphere begins %1 from the eye, within the distance of %2.</source>
        <translation>구가 눈에서 %1 떨어진 곳에서 시작하여 거리 %2 안에 있습니다.</translation>
    </message>
    <message>
        <source>Draw distance</source>
        <translation>그리기 거리</translation>
    </message>
    <message>
        <source>Draw &amp;distance</source>
        <translation>그리기 거리(&amp;D)</translation>
    </message>
    <message>
        <source>Show in the active view how far from the culling eye objects are drawn</source>
        <translation>컬링 눈에서 얼마나 멀리까지 물체를 그리는지 활성 뷰에 표시합니다</translation>
    </message>
    <message>
        <source>limit = distance × scene radius</source>
        <translation>한계 = 거리 × 장면 구의 반지름</translation>
    </message>
    <message>
        <source>d = distance of its sphere</source>
        <translation>d = 구의 가장 가까운 점까지의 거리</translation>
    </message>
    <message>
        <source>if d &gt; limit: leave it out</source>
        <translation>d &gt; 한계이면: 제외</translation>
    </message>
    <message>
        <source>else draw it</source>
        <translation>아니면 그림</translation>
    </message>
    <message>
        <source>How far from the eye objects are drawn, in radii of the scene&apos;s sphere.</source>
        <translation>눈에서 얼마나 멀리까지 물체를 그리는지, 장면 구의 반지름 단위.</translation>
    </message>
    <message>
        <source>Leaves out objects that lie wholly beyond a distance from the eye.</source>
        <translation>눈에서 일정 거리 너머에 완전히 있는 물체를 제외합니다.</translation>
    </message>
    <message>
        <source>triangles to the raster</source>
        <translation>삼각형을 래스터로</translation>
    </message>
    <message>
        <source>rasterising</source>
        <translation>래스터화</translation>
    </message>
    <message>
        <source>Of its %1 triangles %2 lie beyond a plane of the frustum and %3 are turned away: they are not drawn.</source>
        <translation>삼각형 %1개 가운데 %2개는 절두체의 한 평면 밖에 있고 %3개는 뒤를 향함: 그리지 않습니다.</translation>
    </message>
    <message>
        <source>depth comparisons</source>
        <translation>깊이 비교</translation>
    </message>
    <message>
        <source>samples written</source>
        <translation>기록된 표본</translation>
    </message>
    <message>
        <source>pixels that show a surface</source>
        <translation>면이 보이는 픽셀</translation>
    </message>
    <message>
        <source>comparisons of a depth buffer</source>
        <translation>깊이 버퍼라면 했을 비교</translation>
    </message>
    <message>
        <source>spans</source>
        <translation>스팬</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: it is nearer.</source>
        <translation>%1열에서 면이 시작함. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 더 가깝습니다.</translation>
    </message>
    <message>
        <source>Whether parts of the picture are drawn on all processors at once; the picture is the same.</source>
        <translation>그림의 부분들을 모든 프로세서에서 동시에 그릴지 여부. 그림은 같습니다.</translation>
    </message>
    <message>
        <source>Depth buffer, in software</source>
        <translation>깊이 버퍼, 소프트웨어</translation>
    </message>
    <message>
        <source>Draws every triangle on the processor and keeps the nearest surface at each sample.</source>
        <translation>모든 삼각형을 프로세서에서 그리고 표본마다 가장 가까운 면을 남깁니다.</translation>
    </message>
    <message>
        <source>clear all depths to the farthest</source>
        <translation>모든 깊이를 가장 먼 값으로</translation>
    </message>
    <message>
        <source>for each triangle, in any order</source>
        <translation>각 삼각형마다, 순서 무관</translation>
    </message>
    <message>
        <source>transform, clip at the near plane</source>
        <translation>변환, 근평면에서 자름</translation>
    </message>
    <message>
        <source>for each sample it covers</source>
        <translation>덮는 표본마다</translation>
    </message>
    <message>
        <source>z = its depth there</source>
        <translation>z = 그곳의 깊이</translation>
    </message>
    <message>
        <source>if z is nearer than the stored</source>
        <translation>z가 저장값보다 가까우면</translation>
    </message>
    <message>
        <source>store z and the triangle</source>
        <translation>z와 삼각형을 저장</translation>
    </message>
    <message>
        <source>show what is stored</source>
        <translation>저장된 것을 표시</translation>
    </message>
    <message>
        <source>Comparisons of depths</source>
        <translation>깊이 비교 횟수</translation>
    </message>
    <message>
        <source>Scan line, in software</source>
        <translation>스캔라인, 소프트웨어</translation>
    </message>
    <message>
        <source>Draws row by row on the processor and compares depths only where surfaces begin, end or cross.</source>
        <translation>프로세서에서 한 행씩 그리며 면이 시작하거나 끝나거나 교차하는 곳에서만 깊이를 비교합니다.</translation>
    </message>
    <message>
        <source>edge table: edges by their first row</source>
        <translation>변 표: 첫 행별 변</translation>
    </message>
    <message>
        <source>for each row: its active edges</source>
        <translation>각 행마다: 활성 변</translation>
    </message>
    <message>
        <source>begins: compare with the front</source>
        <translation>시작: 맨 앞과 비교</translation>
    </message>
    <message>
        <source>front ends: compare the others</source>
        <translation>맨 앞 끝: 나머지를 비교</translation>
    </message>
    <message>
        <source>two cross: compare, split the span</source>
        <translation>교차: 비교, 스팬 나눔</translation>
    </message>
    <message>
        <source>fill the span, comparing nothing</source>
        <translation>비교 없이 스팬을 채움</translation>
    </message>
    <message>
        <source>the row is done</source>
        <translation>행 끝</translation>
    </message>
    <message>
        <source>show the rows</source>
        <translation>행들을 표시</translation>
    </message>
    <message>
        <source>stopped at the limit</source>
        <translation>한도에서 멈춤</translation>
    </message>
    <message>
        <source>BSP trees by the choice of the dividing plane</source>
        <translation>분할 평면의 선택에 따른 BSP 트리</translation>
    </message>
    <message>
        <source>&quot;random, small&quot;: 10,000 random triangles in a cube, with edges of at most a tenth of its side. &quot;random, large&quot;: with edges of up to its side, which fill it.</source>
        <translation>&quot;random, small&quot;: 정육면체 안의 무작위 삼각형 10,000개, 변의 길이는 한 변의 10분의 1 이하. &quot;random, large&quot;: 변이 한 변만큼 길어 정육면체를 채움.</translation>
    </message>
    <message>
        <source>A tree that needs more than 2,000,000 polygons is given up.</source>
        <translation>다각형이 2,000,000개를 넘게 필요한 트리는 포기합니다.</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>평면</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>polygons</source>
        <translation>다각형</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>노드</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>깊이</translation>
    </message>
    <message>
        <source>tree</source>
        <translation>트리</translation>
    </message>
    <message>
        <source>Computed from the scene of the same name: its planes P1, P2, … divide it level by level, and its objects hang at the leaves. C1 is the leaf behind all planes, the last one before all of them.</source>
        <translation>같은 이름의 장면에서 계산합니다. 평면 P1, P2, …가 단계마다 장면을 나누고 물체는 잎에 달립니다. C1은 모든 평면의 뒤에 있는 잎이고, 마지막 잎은 모든 평면의 앞에 있습니다.</translation>
    </message>
    <message>
        <source>The order is that of drawing, back to front, as seen from the scene&apos;s camera V.</source>
        <translation>순서는 장면의 카메라 V에서 볼 때 뒤에서 앞으로 그리는 순서입니다.</translation>
    </message>
    <message>
        <source>asked</source>
        <translation>문항</translation>
    </message>
    <message>
        <source>answer key</source>
        <translation>정답</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>계산</translation>
    </message>
    <message>
        <source>differs</source>
        <translation>다름</translation>
    </message>
    <message>
        <source>The lecture&apos;s quiz: leaves of a BSP tree and the order of drawing</source>
        <translation>강의의 퀴즈: BSP 트리의 잎과 그리는 순서</translation>
    </message>
    <message>
        <source>The lecture&apos;s worked example of a BSP tree</source>
        <translation>강의의 BSP 트리 예제 풀이</translation>
    </message>
    <message>
        <source>The lecture&apos;s verdicts: very little depth overlap, painter&apos;s algorithm or BSP tree; little overlap, scan line; few surfaces, painter, BSP tree, scan line; many surfaces, depth buffer, octree; several views of a static scene, BSP tree. It gives no numbers: here 1 layer is very little overlap, 2 are little, 10 surfaces are few, 100,000 many.</source>
        <translation>강의의 평가: 깊이 겹침이 아주 적으면 화가 알고리즘이나 BSP 트리, 조금 있으면 스캔 라인, 면이 적으면 화가 알고리즘, BSP 트리, 스캔 라인, 면이 많으면 깊이 버퍼와 옥트리, 정지한 장면을 여러 시점에서 보면 BSP 트리. 강의에는 수치가 없습니다. 여기서는 층 1개가 아주 적은 겹침, 2개가 적은 겹침, 면 10개가 적은 수, 100,000개가 많은 수입니다.</translation>
    </message>
    <message>
        <source>A verdict and the measurement agree where the method takes at most 1.25 times the least time of the first five methods, the structure built once and all views drawn.</source>
        <translation>구조를 한 번 만들고 모든 시점을 그렸을 때 방법이 앞의 다섯 방법 중 가장 짧은 시간의 1.25배 이하이면 평가와 측정이 일치합니다.</translation>
    </message>
    <message>
        <source>all and backface are the GPU&apos;s depth buffer, which the lecture says is used most; they are not among those that its verdicts compare. painter, bsp and octree-query draw with OpenGL, depth-buffer and scan-line on the processor.</source>
        <translation>all과 backface는 GPU의 깊이 버퍼로, 강의에 따르면 가장 많이 쓰입니다. 강의가 비교하는 방법에는 들지 않습니다. painter, bsp, octree-query는 OpenGL로, depth-buffer와 scan-line은 프로세서로 그립니다.</translation>
    </message>
    <message>
        <source>The scenes are layers with waves of height 0.02, so that their triangles lie in planes of their own and the layers do not meet: a BSP tree of flat layers would have a node a layer. With more layers than surfaces each has two triangles.</source>
        <translation>장면은 높이 0.02의 물결이 있는 층입니다. 그래서 삼각형마다 자기 평면이 있고 층끼리는 만나지 않습니다. 평평한 층이라면 BSP 트리의 노드는 층마다 하나뿐입니다. 층이 면보다 많으면 층마다 삼각형이 두 개입니다.</translation>
    </message>
    <message>
        <source>lecture: good for</source>
        <translation>강의: 알맞은 경우</translation>
    </message>
    <message>
        <source>all views, ms</source>
        <translation>모든 시점, ms</translation>
    </message>
    <message>
        <source>both, ms</source>
        <translation>합계, ms</translation>
    </message>
    <message>
        <source>both ÷ least of five</source>
        <translation>합계 ÷ 다섯 중 최소</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>평가</translation>
    </message>
    <message>
        <source>milliseconds, built and all views drawn</source>
        <translation>밀리초, 구조 생성과 모든 시점 그리기</translation>
    </message>
    <message>
        <source>The lecture&apos;s methods by overlap, surfaces and views</source>
        <translation>겹침, 면, 시점에 따른 강의의 방법들</translation>
    </message>
    <message>
        <source>layers</source>
        <translation>층</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>면</translation>
    </message>
    <message>
        <source>method</source>
        <translation>방법</translation>
    </message>
    <message>
        <source>Time by layers</source>
        <translation>층 수에 따른 시간</translation>
    </message>
    <message>
        <source>Time by surfaces</source>
        <translation>면 수에 따른 시간</translation>
    </message>
    <message>
        <source>Time by views of a static scene</source>
        <translation>정지한 장면의 시점 수에 따른 시간</translation>
    </message>
    <message>
        <source>A test</source>
        <translation>시험</translation>
    </message>
    <message>
        <source>Drawn completely</source>
        <translation>전부 그림</translation>
    </message>
    <message>
        <source>Drawn in part</source>
        <translation>일부 그림</translation>
    </message>
    <message>
        <source>Left out completely</source>
        <translation>전부 제외</translation>
    </message>
    <message>
        <source>Drawn after all</source>
        <translation>결국 그려짐</translation>
    </message>
    <message>
        <source>About an object</source>
        <translation>물체에 관한 것</translation>
    </message>
    <message>
        <source>About a node</source>
        <translation>노드에 관한 것</translation>
    </message>
    <message>
        <source>About a cell</source>
        <translation>셀에 관한 것</translation>
    </message>
    <message>
        <source>About a ray</source>
        <translation>광선에 대해</translation>
    </message>
    <message>
        <source>About a band</source>
        <translation>띠에 대해</translation>
    </message>
    <message>
        <source>About a part of a triangle</source>
        <translation>삼각형의 일부에 관한 것</translation>
    </message>
    <message>
        <source>About a piece of a row</source>
        <translation>행의 일부에 관한 것</translation>
    </message>
    <message>
        <source>Triangles of the scene are drawn</source>
        <translation>장면의 삼각형을 그림</translation>
    </message>
    <message>
        <source>Triangles of the strategy&apos;s own are drawn</source>
        <translation>전략이 만든 삼각형을 그림</translation>
    </message>
    <message>
        <source>A finished picture is shown</source>
        <translation>완성된 그림을 보임</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes</source>
        <translation>상자를 OpenGL에 물음</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>제외: %1</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>%1행</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>%1행: %2</translation>
    </message>
    <message>
        <source>Drawn in part; the rest is left out: %1</source>
        <translation>일부만 그리고 나머지는 제외: %1</translation>
    </message>
    <message>
        <source>Is drawn</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>Left out before, and drawn after all</source>
        <translation>앞서 제외되었으나 결국 그려짐</translation>
    </message>
    <message>
        <source>Tested</source>
        <translation>시험함</translation>
    </message>
    <message>
        <source>Triangles of the strategy&apos;s own are drawn: %1</source>
        <translation>전략이 만든 삼각형을 그림: %1개</translation>
    </message>
    <message>
        <source>A picture that the strategy made is shown: %1 × %2 pixels</source>
        <translation>전략이 만든 그림을 보임: %1 × %2 픽셀</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>물체 %1</translation>
    </message>
    <message>
        <source>Node %1</source>
        <translation>노드 %1</translation>
    </message>
    <message>
        <source>Cell %1 of %2</source>
        <translation>%2의 셀 %1</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>셀 %1</translation>
    </message>
    <message>
        <source>Ray %1 to %2</source>
        <translation>%2(으)로 가는 광선 %1</translation>
    </message>
    <message>
        <source>Ray %1</source>
        <translation>광선 %1</translation>
    </message>
    <message>
        <source>Band %1 of %2</source>
        <translation>%2의 띠 %1</translation>
    </message>
    <message>
        <source>Band %1</source>
        <translation>띠 %1</translation>
    </message>
    <message>
        <source>Piece %1 of a row, of %2</source>
        <translation>%2의 행 조각 %1</translation>
    </message>
    <message>
        <source>Piece %1 of a row</source>
        <translation>행 조각 %1</translation>
    </message>
    <message>
        <source>N poses before the scene&apos;s front, looking along -z, which the scene fills</source>
        <translation>장면 앞에서 -z 방향으로 보며 장면이 화면을 채우는 N개 자세</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is none of polygon, plane, eye and camera. Write one of them, or # before a comment.</source>
        <translation>%1, %2행: &quot;%3&quot;은(는) polygon, plane, eye, camera 가운데 어느 것도 아닙니다. 이 가운데 하나를 쓰거나 주석 앞에 #을 붙이십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: the camera looks at its own place. Give it another target.</source>
        <translation>%1, %2행: 카메라가 자기 자리를 보고 있습니다. 다른 목표점을 주십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: a name is missing before the numbers. Write for example polygon A 0 0 0  1 0 0  0 1 0.</source>
        <translation>%1, %2행: 숫자 앞에 이름이 없습니다. 예를 들어 polygon A 0 0 0  1 0 0  0 1 0 처럼 쓰십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: the name &quot;%3&quot; is used twice. Give each its own.</source>
        <translation>%1, %2행: 이름 &quot;%3&quot;이(가) 두 번 쓰였습니다. 각각 다른 이름을 주십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: a polygon has three coordinates for each of three or more corners; here are %3 numbers.</source>
        <translation>%1, %2행: 다각형은 셋 이상의 꼭짓점마다 좌표 셋을 가집니다. 여기에는 수가 %3개 있습니다.</translation>
    </message>
    <message>
        <source>%1, line %2: the polygon&apos;s corners do not lie in one plane. Write it as several polygons.</source>
        <translation>%1, %2행: 다각형의 꼭짓점이 한 평면에 있지 않습니다. 여러 다각형으로 나누어 쓰십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: a plane is written as a b c d, for ax + by + cz + d = 0, or as a point and a normal, six numbers; here are %3.</source>
        <translation>%1, %2행: 평면은 ax + by + cz + d = 0 의 a b c d 로, 또는 점과 법선의 수 여섯 개로 씁니다. 여기에는 %3개가 있습니다.</translation>
    </message>
    <message>
        <source>%1, line %2: the file has a camera already.</source>
        <translation>%1, %2행: 파일에 카메라가 이미 있습니다.</translation>
    </message>
    <message>
        <source>%1, line %2: an eye has three numbers, a camera six: its place and where it looks.</source>
        <translation>%1, %2행: eye는 수 세 개, camera는 여섯 개를 가집니다. 자리와 바라보는 곳입니다.</translation>
    </message>
    <message>
        <source>sheets one behind the other, each an object: seen from the front, the first one hides the others</source>
        <translation>앞뒤로 놓인 층들, 층마다 한 물체: 앞에서 보면 첫째 층이 나머지를 가립니다</translation>
    </message>
    <message>
        <source>how many layers</source>
        <translation>층의 수</translation>
    </message>
    <message>
        <source>how many triangles each layer has, to the nearest that its grid allows</source>
        <translation>층마다의 삼각형 수, 격자가 허용하는 가장 가까운 수</translation>
    </message>
    <message>
        <source>height of the layers&apos; waves; 0: they are flat</source>
        <translation>층의 물결 높이; 0: 평평함</translation>
    </message>
    <message>
        <source>the lecture&apos;s quiz: polygons A, B and C, and the planes P1 to P3 that divide them</source>
        <translation>강의의 퀴즈: 다각형 A, B, C와 이를 나누는 평면 P1~P3</translation>
    </message>
    <message>
        <source>the lecture&apos;s worked example: polygons A to D, divided by the planes P1 and P2</source>
        <translation>강의의 예제: 평면 P1과 P2로 나눈 다각형 A~D</translation>
    </message>
    <message>
        <source>plane=given takes the planes that a scene has. &quot;%1&quot; has none: name them in a .polygons file, or take another choice of plane.</source>
        <translation>plane=given은 장면에 있는 평면을 씁니다. &quot;%1&quot;에는 평면이 없습니다. .polygons 파일에 평면을 쓰거나 다른 평면 선택을 쓰십시오.</translation>
    </message>
    <message>
        <source>Building the BSP tree</source>
        <translation>BSP 트리 만드는 중</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 polygons are not divided yet. Take fewer triangles, another choice of plane (plane=fewest), or a higher limit.</source>
        <translation>&quot;%1&quot;의 BSP 트리에는 다각형이 %2개를 넘게 필요합니다. 삼각형 %3개가 %4번 잘렸고 다각형 %5개가 아직 나뉘지 않았습니다. 삼각형 수를 줄이거나, 다른 평면 선택(plane=fewest) 또는 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>The painter&apos;s order of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times. Take fewer triangles, sort=centroid, or a higher limit.</source>
        <translation>&quot;%1&quot;의 화가 순서에는 다각형이 %2개를 넘게 필요합니다. 삼각형 %3개가 %4번 잘렸습니다. 삼각형 수를 줄이거나, sort=centroid 또는 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>groups outside the frustum</source>
        <translation>절두체 밖의 그룹</translation>
    </message>
    <message>
        <source>groups visible without asking</source>
        <translation>묻지 않고 보이는 그룹</translation>
    </message>
    <message>
        <source>groups asked about</source>
        <translation>물어본 그룹</translation>
    </message>
    <message>
        <source>groups hidden</source>
        <translation>가려진 그룹</translation>
    </message>
    <message>
        <source>objects drawn</source>
        <translation>그린 물체</translation>
    </message>
    <message>
        <source>walk and queries</source>
        <translation>순회와 질의</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; lies in a box of the octree; it has %2 triangles.</source>
        <translation>&quot;%1&quot; 물체는 옥트리의 한 상자에 있고 삼각형이 %2개입니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, of which all are drawn where their box is visible.</source>
        <translation>물체 %1개의 그룹에 있으며, 상자가 보이면 모두 그립니다.</translation>
    </message>
    <message>
        <source>visit(group)</source>
        <translation>방문(그룹)</translation>
    </message>
    <message>
        <source>test its box against the frustum</source>
        <translation>그룹의 상자를 절두체로 검사</translation>
    </message>
    <message>
        <source>first, or across near plane: visible</source>
        <translation>첫째이거나 근평면에 걸치면: 보임</translation>
    </message>
    <message>
        <source>else ask OpenGL: does its box show?</source>
        <translation>아니면 OpenGL에 상자가 보이는지 물음</translation>
    </message>
    <message>
        <source>no: hidden, leave all its objects out</source>
        <translation>아니요: 가려짐, 물체를 모두 제외</translation>
    </message>
    <message>
        <source>yes: visit(parts), nearest first</source>
        <translation>예: 방문(부분), 가까운 것부터</translation>
    </message>
    <message>
        <source>no parts: draw its objects</source>
        <translation>부분이 없으면: 물체를 그림</translation>
    </message>
    <message>
        <source>Octree with occlusion queries</source>
        <translation>차폐 질의를 쓰는 옥트리</translation>
    </message>
    <message>
        <source>Draws an octree&apos;s objects from near to far, and first asks OpenGL of each group whether its box shows.</source>
        <translation>옥트리의 물체를 가까운 것부터 그리며, 그룹마다 먼저 상자가 보이는지 OpenGL에 묻습니다.</translation>
    </message>
    <message>
        <source>How many frames later an answer is used; 0: each batch is waited for, and nothing is lost.</source>
        <translation>답을 몇 프레임 뒤에 쓰는지; 0: 묶음마다 답을 기다리며 아무것도 잃지 않습니다.</translation>
    </message>
    <message>
        <source>How many boxes are asked about at once, at most: more need fewer waits, and hide less from each other. The lecture asks one by one.</source>
        <translation>한 번에 물어보는 상자의 최대 수: 많으면 덜 기다리지만 서로를 덜 가립니다. 강의에서는 하나씩 묻습니다.</translation>
    </message>
    <message>
        <source>Which groups OpenGL is asked about.</source>
        <translation>어떤 그룹을 OpenGL에 물어보는지.</translation>
    </message>
    <message>
        <source>every group before its parts</source>
        <translation>모든 그룹을 그 부분보다 먼저</translation>
    </message>
    <message>
        <source>only groups without parts, as in the lecture</source>
        <translation>강의처럼 부분이 없는 그룹만</translation>
    </message>
    <message>
        <source>How many objects a group may have that is not divided into parts.</source>
        <translation>나누지 않는 그룹이 가질 수 있는 물체의 수.</translation>
    </message>
    <message>
        <source>Groups by what was asked</source>
        <translation>물어본 결과에 따른 그룹</translation>
    </message>
    <message>
        <source>Nothing is drawn yet that could hide its box: it counts as visible without asking.</source>
        <translation>상자를 가릴 만한 것이 아직 그려지지 않았습니다. 묻지 않고 보이는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about its box, grown by %2: it shows before what is drawn.</source>
        <translation>%2만큼 키운 상자를 OpenGL에 물었습니다. 그려진 것 앞에 보입니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about its box, grown by %2: what is drawn hides all of it.</source>
        <translation>%2만큼 키운 상자를 OpenGL에 물었습니다. 그려진 것이 상자를 모두 가립니다.</translation>
    </message>
    <message>
        <source>Its box was not asked about %1 frames ago: it counts as visible, and is asked about now.</source>
        <translation>%1프레임 전에는 상자를 묻지 않았습니다. 보이는 것으로 보고 지금 묻습니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %2, is asked about; %1 frames ago the answer was that it shows.</source>
        <translation>%2만큼 키운 상자를 묻습니다. %1프레임 전의 답은 보인다는 것이었습니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %2, is asked about; %1 frames ago the answer was that it is hidden.</source>
        <translation>%2만큼 키운 상자를 묻습니다. %1프레임 전의 답은 가려졌다는 것이었습니다.</translation>
    </message>
    <message>
        <source>The box counts as visible: its parts are visited, nearest first.</source>
        <translation>상자를 보이는 것으로 봅니다. 부분을 가까운 것부터 방문합니다.</translation>
    </message>
    <message>
        <source>The eye lies %1 before the plane of node %2.</source>
        <translation>눈은 노드 %2의 평면보다 %1 앞에 있습니다.</translation>
    </message>
    <message>
        <source>The eye lies %1 behind the plane of node %2.</source>
        <translation>눈은 노드 %2의 평면보다 뒤에 있습니다(%1).</translation>
    </message>
    <message>
        <source>The eye lies in the plane of node %2, at %1: its sides may come in any order.</source>
        <translation>눈은 노드 %2의 평면 위에 있습니다(%1). 양쪽의 순서는 상관없습니다.</translation>
    </message>
    <message>
        <source>A part with %1 of the area of triangle %2 is drawn, with node %3.</source>
        <translation>삼각형 %2 넓이의 %1인 부분을 노드 %3에서 그립니다.</translation>
    </message>
    <message>
        <source>the eye is before the plane</source>
        <translation>눈이 평면 앞에 있음</translation>
    </message>
    <message>
        <source>the eye is behind the plane</source>
        <translation>눈이 평면 뒤에 있음</translation>
    </message>
    <message>
        <source>the eye is in the plane</source>
        <translation>눈이 평면 위에 있음</translation>
    </message>
    <message>
        <source>The tree has the triangle in %1 parts, each drawn where the walk comes to it.</source>
        <translation>트리에는 이 삼각형이 %1개의 부분으로 있고, 순회가 이르는 곳에서 각각 그립니다.</translation>
    </message>
    <message>
        <source>walking the tree</source>
        <translation>트리 순회</translation>
    </message>
    <message>
        <source>The walk starts at the root: %1 nodes, %2 polygons.</source>
        <translation>순회는 뿌리에서 시작합니다. 노드 %1개, 다각형 %2개.</translation>
    </message>
    <message>
        <source>Splitting planes</source>
        <translation>분할 평면</translation>
    </message>
    <message>
        <source>&amp;Splitting planes</source>
        <translation>분할 평면(&amp;S)</translation>
    </message>
    <message>
        <source>Show in the active view the first planes of the BSP tree, each within its cell</source>
        <translation>활성 뷰에 BSP 트리의 처음 평면들을 각 셀 안에 표시</translation>
    </message>
    <message>
        <source>node = root</source>
        <translation>노드 = 뿌리</translation>
    </message>
    <message>
        <source>s = side of node&apos;s plane that V is on</source>
        <translation>s = 노드 평면에서 V가 있는 쪽</translation>
    </message>
    <message>
        <source>draw what lies in the plane</source>
        <translation>평면에 놓인 것을 그립니다</translation>
    </message>
    <message>
        <source>In which order the tree is walked.</source>
        <translation>트리를 순회하는 순서.</translation>
    </message>
    <message>
        <source>far to near, without depth test</source>
        <translation>먼 것부터, 깊이 검사 없이</translation>
    </message>
    <message>
        <source>near to far, with depth test</source>
        <translation>가까운 것부터, 깊이 검사와 함께</translation>
    </message>
    <message>
        <source>Which plane divides the polygons of a node.</source>
        <translation>노드의 다각형을 나누는 평면.</translation>
    </message>
    <message>
        <source>that of its first polygon</source>
        <translation>첫 다각형의 평면</translation>
    </message>
    <message>
        <source>of some candidates the one that cuts the fewest polygons</source>
        <translation>후보 가운데 다각형을 가장 적게 자르는 평면</translation>
    </message>
    <message>
        <source>of some candidates the one that divides them best</source>
        <translation>후보 가운데 가장 고르게 나누는 평면</translation>
    </message>
    <message>
        <source>the planes that the scene names, one for each level</source>
        <translation>장면이 이름 붙인 평면, 단계마다 하나</translation>
    </message>
    <message>
        <source>How many planes are tried at a node (plane=fewest and balance).</source>
        <translation>노드에서 시험하는 평면의 수(plane=fewest, balance).</translation>
    </message>
    <message>
        <source>BSP tree</source>
        <translation>BSP 트리</translation>
    </message>
    <message>
        <source>Draws all triangles in the order of a BSP tree, cut where its planes pass through them.</source>
        <translation>모든 삼각형을 BSP 트리의 순서로 그리고, 평면이 지나는 곳에서 자릅니다.</translation>
    </message>
    <message>
        <source>Nodes by the eye&apos;s side</source>
        <translation>눈이 있는 쪽에 따른 노드</translation>
    </message>
    <message>
        <source>Nothing is left that has to come before: %1 of the area of triangle %2 is drawn.</source>
        <translation>먼저 와야 할 것이 남지 않았습니다. 삼각형 %2 넓이의 %1을(를) 그립니다.</translation>
    </message>
    <message>
        <source>3: P is behind Q&apos;s plane</source>
        <translation>3: P가 Q의 평면 뒤에 있음</translation>
    </message>
    <message>
        <source>4: Q is before P&apos;s plane</source>
        <translation>4: Q가 P의 평면 앞에 있음</translation>
    </message>
    <message>
        <source>5: projections apart</source>
        <translation>5: 투영이 떨어져 있음</translation>
    </message>
    <message>
        <source>Q is taken first</source>
        <translation>Q를 먼저 다룸</translation>
    </message>
    <message>
        <source>one is cut</source>
        <translation>하나를 자름</translation>
    </message>
    <message>
        <source>sorting</source>
        <translation>정렬</translation>
    </message>
    <message>
        <source>%1 polygons are sorted by their farthest depth.</source>
        <translation>다각형 %1개를 가장 먼 깊이로 정렬합니다.</translation>
    </message>
    <message>
        <source>P = the farthest one left</source>
        <translation>P = 남은 것 중 가장 먼 것</translation>
    </message>
    <message>
        <source>for each Q that P overlaps in depth</source>
        <translation>깊이가 P와 겹치는 각 Q에 대해</translation>
    </message>
    <message>
        <source>1, 2: apart in x or y? next Q</source>
        <translation>1, 2: x나 y가 떨어짐? 다음 Q</translation>
    </message>
    <message>
        <source>3: P behind Q&apos;s plane? next Q</source>
        <translation>3: P가 Q 평면 뒤? 다음 Q</translation>
    </message>
    <message>
        <source>4: Q before P&apos;s plane? next Q</source>
        <translation>4: Q가 P 평면 앞? 다음 Q</translation>
    </message>
    <message>
        <source>5: projections apart? next Q</source>
        <translation>5: 투영이 떨어짐? 다음 Q</translation>
    </message>
    <message>
        <source>Q marked, or they pierce: cut</source>
        <translation>Q가 표시됨 또는 관통: 자름</translation>
    </message>
    <message>
        <source>else mark P; P = Q, from line 3</source>
        <translation>아니면 P 표시; P = Q, 3행부터</translation>
    </message>
    <message>
        <source>Painter&apos;s algorithm</source>
        <translation>화가 알고리즘</translation>
    </message>
    <message>
        <source>Draws all triangles from far to near without depth test, and cuts those that wait for each other.</source>
        <translation>모든 삼각형을 깊이 검사 없이 먼 것부터 그리고, 서로를 기다리는 것은 자릅니다.</translation>
    </message>
    <message>
        <source>How the triangles are sorted.</source>
        <translation>삼각형을 정렬하는 방법.</translation>
    </message>
    <message>
        <source>by the tests of Newell, Newell and Sancha</source>
        <translation>Newell, Newell, Sancha의 검사로</translation>
    </message>
    <message>
        <source>by the distance of their centroids alone; shows wrong pixels</source>
        <translation>무게중심의 거리만으로, 틀린 픽셀이 나타남</translation>
    </message>
    <message>
        <source>How many polygons a frame may have, the cut ones among them.</source>
        <translation>잘린 것을 포함해 한 프레임이 가질 수 있는 다각형의 수.</translation>
    </message>
    <message>
        <source>Comparisons by what decided</source>
        <translation>무엇이 결정했는지에 따른 비교</translation>
    </message>
    <message>
        <source>All normals in the cell&apos;s cone are turned to the eye: cones are not tested in its parts.</source>
        <translation>셀의 원뿔에 든 법선이 모두 눈을 향합니다. 그 부분들에서는 원뿔을 검사하지 않습니다.</translation>
    </message>
    <message>
        <source>The planes of its triangles have the eye behind them by at least %1, more than the %2 that rounding and snapping may undo.</source>
        <translation>눈이 삼각형들의 평면 뒤로 적어도 %1 떨어져 있으며, 반올림과 스냅이 되돌릴 수 있는 %2보다 큽니다.</translation>
    </message>
    <message>
        <source>The planes of its triangles have the eye behind them by at least %1: not more than the %2 that rounding and snapping may undo.</source>
        <translation>눈이 삼각형들의 평면 뒤로 적어도 %1 떨어져 있지만, 반올림과 스냅이 되돌릴 수 있는 %2보다 크지 않습니다.</translation>
    </message>
    <message>
        <source>Its sphere reaches the slope %1; the kernel&apos;s horizon before it is not everywhere higher (%2): part of it may be visible.</source>
        <translation>구가 기울기 %1까지 이릅니다. 그 앞 커널의 지평선이 모든 곳에서 더 높지는 않습니다(%2). 일부가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>Its sphere reaches the slope %1; the kernel&apos;s horizon before it is higher, at least %2: hidden.</source>
        <translation>구가 기울기 %1까지 이릅니다. 그 앞 커널의 지평선이 적어도 %2로 더 높습니다. 가려집니다.</translation>
    </message>
    <message>
        <source>Its sphere begins at the slope %1, above the kernel&apos;s horizon, at most %2: the kernel hides none of it.</source>
        <translation>구가 기울기 %1에서 시작하며, 많아야 %2인 커널의 지평선보다 위입니다. 커널이 아무것도 가리지 않습니다.</translation>
    </message>
    <message>
        <source>Left out, but drawn after all: it lies between two ranges, and fewer than %1 triangles are not worth a range of their own.</source>
        <translation>제외되었으나 결국 그려집니다. 두 구간 사이에 있고, %1개보다 적은 삼각형은 구간을 따로 둘 만하지 않습니다.</translation>
    </message>
    <message>
        <source>Corner ray %1 passes %2 cells of the map and hits a triangle at R = %3.</source>
        <translation>%1번 모서리 광선은 맵의 셀 %2개를 지나 R = %3에서 삼각형에 맞습니다.</translation>
    </message>
    <message>
        <source>A test left the cell out, but it is drawn with the ranges on both of its sides: so few triangles are not worth a range of their own.</source>
        <translation>검사로 제외된 셀이지만 양쪽 구간과 함께 그려집니다. 이렇게 적은 삼각형은 구간을 따로 둘 만하지 않습니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box was tested first: what was drawn before hides it.</source>
        <translation>물체 %1개의 그룹에 속하며, 그룹의 상자를 먼저 검사합니다: 먼저 그려진 것이 가립니다.</translation>
    </message>
    <message>
        <source>index map</source>
        <translation>색인 맵</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names no camera, from which the order is seen. Write a line eye x y z into its .polygons file.</source>
        <translation>&quot;%1&quot;에는 순서를 볼 카메라가 없습니다. .polygons 파일에 eye x y z 행을 쓰십시오.</translation>
    </message>
    <message>
        <source>Leaves of a BSP tree and the order of drawing</source>
        <translation>BSP 트리의 잎과 그리는 순서</translation>
    </message>
    <message>
        <source>Computed from the scene&apos;s own planes, which divide it level by level; its objects hang at the leaves. C1 is the leaf behind all planes, the last one before all of them.</source>
        <translation>장면에 있는 평면으로 계산합니다. 평면이 단계마다 장면을 나누고 물체는 잎에 달립니다. C1은 모든 평면의 뒤에 있는 잎이고, 마지막 잎은 모든 평면의 앞에 있습니다.</translation>
    </message>
    <message>
        <source>Bytes are of what the method built, of what a frame needed besides (tables, lists, its triangles or its picture), and of the GPU&apos;s depth buffer where it is used. Missed pixels are those of all views.</source>
        <translation>바이트는 방법이 만든 것, 한 프레임에 그 밖에 필요했던 것(표, 목록, 방법이 만든 삼각형이나 그림), 그리고 GPU의 깊이 버퍼를 쓰는 경우 그 크기입니다. 놓친 픽셀은 모든 시점의 것입니다.</translation>
    </message>
    <message>
        <source>covers no sample</source>
        <translation>표본을 하나도 덮지 않음</translation>
    </message>
    <message>
        <source>About several cells</source>
        <translation>여러 셀에 관한 것</translation>
    </message>
    <message>
        <source>Cells of %1</source>
        <translation>%1의 셀들</translation>
    </message>
    <message>
        <source>Several cells</source>
        <translation>여러 셀</translation>
    </message>
    <message>
        <source>%1 names no polygon. Write at least one line such as polygon A 0 0 0  1 0 0  0 1 0.</source>
        <translation>%1에 다각형이 없습니다. polygon A 0 0 0  1 0 0  0 1 0 과 같은 행을 하나 이상 쓰십시오.</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 nodes: each of its %3 planes divides every cell of the one before. Name fewer planes, or take a higher limit.</source>
        <translation>&quot;%1&quot;의 BSP 트리에는 노드가 %2개를 넘게 필요합니다. 평면 %3개가 저마다 앞 평면의 모든 셀을 나눕니다. 평면 수를 줄이거나 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>draw it: OpenGL drops back faces</source>
        <translation>그림: 뒷면은 OpenGL이 버림</translation>
    </message>
    <message>
        <source>The walk comes to node %1, on the eye&apos;s side of the plane of node %2.</source>
        <translation>순회가 노드 %1에 옵니다. 노드 %2의 평면에서 눈과 같은 쪽입니다.</translation>
    </message>
    <message>
        <source>The walk comes to node %1, beyond the plane of node %2.</source>
        <translation>순회가 노드 %1에 옵니다. 노드 %2의 평면 너머입니다.</translation>
    </message>
    <message>
        <source>%1: %2 polygons</source>
        <translation>%1: 다각형 %2개</translation>
    </message>
    <message>
        <source>How many polygons the tree may have, the cut ones among them, and how many nodes.</source>
        <translation>트리가 가질 수 있는 다각형의 수(잘린 것 포함)와 노드의 수.</translation>
    </message>
    <message>
        <source>Triangle %1 is the farthest one left, with the farthest depth %2.</source>
        <translation>%1 삼각형이 남은 것 가운데 가장 멉니다. 가장 먼 깊이는 %2입니다.</translation>
    </message>
    <message>
        <source>The triangle lies beyond a plane of the frustum.</source>
        <translation>삼각형이 절두체의 한 평면 밖에 있습니다.</translation>
    </message>
    <message>
        <source>The triangle is turned away.</source>
        <translation>삼각형이 뒤를 향합니다.</translation>
    </message>
    <message>
        <source>The triangle covers no sample: no centre of a pixel lies in it.</source>
        <translation>삼각형이 표본을 하나도 덮지 않음: 그 안에 놓인 픽셀 중심이 없습니다.</translation>
    </message>
    <message>
        <source>At every sample that the triangle covers another surface is in front.</source>
        <translation>삼각형이 덮는 모든 표본에서 다른 면이 앞에 있습니다.</translation>
    </message>
    <message>
        <source>cut: follow four corner rays</source>
        <translation>잘리면: 네 모서리 광선을 따라감</translation>
    </message>
    <message>
        <source>cell by cell: a triangle hit?</source>
        <translation>셀마다: 삼각형에 맞는가?</translation>
    </message>
    <message>
        <source>draw boxes of cells around it</source>
        <translation>이를 감싸는 셀 상자를 그림</translation>
    </message>
    <message>
        <source>yes, or the near half: draw it</source>
        <translation>그렇거나 가까운 절반이면: 그림</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: the surface&apos;s slope is at least %1, and the horizon before it %2.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: 표면의 기울기는 적어도 %1, 그 앞의 지평선은 %2입니다.</translation>
    </message>
    <message>
        <source>The cell&apos;s triangles reach the slope %1; the horizon before them is higher everywhere, at least %2: hidden.</source>
        <translation>셀의 삼각형이 기울기 %1까지 이릅니다. 그 앞의 지평선이 모든 곳에서 적어도 %2로 더 높습니다. 가려집니다.</translation>
    </message>
    <message>
        <source>The cell&apos;s triangles reach the slope %1; the horizon before them is not everywhere higher (%2): drawn.</source>
        <translation>셀의 삼각형이 기울기 %1까지 이릅니다. 그 앞의 지평선이 모든 곳에서 더 높지는 않습니다(%2). 그려집니다.</translation>
    </message>
    <message>
        <source>The cell lies too near to the centre or to the axis, or reaches too far around: drawn without a test.</source>
        <translation>셀이 중심이나 축에 너무 가깝거나 너무 넓게 걸쳐 있습니다. 검사 없이 그립니다.</translation>
    </message>
    <message>
        <source>Ray %1 passes a cell in which no triangle lies.</source>
        <translation>%1번 광선은 삼각형이 없는 셀을 지납니다.</translation>
    </message>
    <message>
        <source>Ray %1 stays at R ≥ %2 in this cell, whose triangles end at R = %3: none of them is hit.</source>
        <translation>이 셀에서 %1번 광선은 R ≥ %2이고 셀의 삼각형은 R = %3에서 끝납니다. 아무것에도 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Ray %1 stays at R ≤ %2 in this cell, whose triangles begin at R = %3: none of them is hit.</source>
        <translation>이 셀에서 %1번 광선은 R ≤ %2이고 셀의 삼각형은 R = %3에서 시작합니다. 아무것에도 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles one is hit.</source>
        <translation>이 셀에서 %1번 광선은 R = %2~%3에 있습니다. 셀의 삼각형 %4개 중 하나에 맞습니다.</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of its %4 triangles none is hit.</source>
        <translation>이 셀에서 %1번 광선은 R = %2~%3에 있습니다. 셀의 삼각형 %4개 중 아무것에도 맞지 않습니다.</translation>
    </message>
    <message>
        <source>Corner ray %1 enters the bounding sphere at R = %2.</source>
        <translation>%1번 모서리 광선은 R = %2에서 경계 구에 들어갑니다.</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°, in the near half: S %1, largest before it %2: drawn.</source>
        <translation>부채꼴 %4, 앞쪽 절반에 있는 α = %3°까지의 띠: S %1, 그 앞의 최댓값 %2. 그려집니다.</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 &gt; %2, the largest before it: drawn.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: S %1 &gt; 그 앞의 최댓값 %2. 그려집니다.</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: S %1 ≤ 그 앞의 최댓값 %2. 가려집니다.</translation>
    </message>
    <message>
        <source>A box around the region: rows %1 to %2 of the map, columns %3 to %4.</source>
        <translation>영역을 감싸는 상자: 맵의 행 %1~%2, 열 %3~%4.</translation>
    </message>
    <message>
        <source>Cells %1 to %2 are one range of the memory access map: %3 triangles from place %4 on are drawn.</source>
        <translation>%1~%2번 셀은 메모리 접근 맵의 한 구간입니다. 자리 %4부터 삼각형 %3개를 그립니다.</translation>
    </message>
    <message>
        <source>not yet decided</source>
        <translation>아직 결정되지 않음</translation>
    </message>
    <message>
        <source>The triangle is in the picture that the strategy made.</source>
        <translation>이 삼각형은 전략이 만든 그림에 있습니다.</translation>
    </message>
    <message>
        <source>The triangle is not in the picture that the strategy made.</source>
        <translation>이 삼각형은 전략이 만든 그림에 없습니다.</translation>
    </message>
    <message>
        <source>%1, which writes and reads pictures, cannot be opened: %2. Install or build Cullscope again.</source>
        <translation>그림을 쓰고 읽는 %1을(를) 열 수 없습니다: %2. Cullscope를 다시 설치하거나 빌드하십시오.</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>조각 %1</translation>
    </message>
    <message>
        <source>Part of triangle %1 of %2</source>
        <translation>%2의 삼각형 %1의 조각</translation>
    </message>
    <message>
        <source>Part of triangle %1</source>
        <translation>삼각형 %1의 조각</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: it has %3 triangles. Take fewer triangles, or a higher limit.</source>
        <translation>&quot;%1&quot;의 BSP 트리에는 다각형이 %2개를 넘게 필요합니다. 삼각형이 %3개입니다. 삼각형 수를 줄이거나 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>The BSP tree of &quot;%1&quot; needs more than %2 polygons: its %3 triangles were cut %4 times, and %5 polygons are not divided yet. Take fewer triangles, or a higher limit.</source>
        <translation>&quot;%1&quot;의 BSP 트리에는 다각형이 %2개를 넘게 필요합니다. 삼각형 %3개가 %4번 잘렸고 다각형 %5개가 아직 나뉘지 않았습니다. 삼각형 수를 줄이거나 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>The painter&apos;s order of &quot;%1&quot; needs more than %2 polygons: it has %3 triangles. Take fewer triangles, or a higher limit.</source>
        <translation>&quot;%1&quot;의 화가 순서에는 다각형이 %2개를 넘게 필요합니다. 삼각형이 %3개입니다. 삼각형 수를 줄이거나 더 큰 한도를 쓰십시오.</translation>
    </message>
    <message>
        <source>Triangle %1, which waited, is taken again; its farthest depth is %2.</source>
        <translation>기다리던 %1 삼각형을 다시 잡습니다. 가장 먼 깊이는 %2입니다.</translation>
    </message>
    <message>
        <source>There is no parameter &quot;%1&quot; here, and no other one.</source>
        <translation>여기에는 &quot;%1&quot; 매개변수가 없으며, 다른 매개변수도 없습니다.</translation>
    </message>
    <message>
        <source>The triangle covers %1 samples. At column %2 of row %3 its depth is %4.</source>
        <translation>삼각형이 표본 %1개를 덮습니다. %3행 %2열에서 깊이는 %4입니다.</translation>
    </message>
    <message>
        <source>Its depth %1 there does not exceed the stored %2. It is nearer at none of its samples.</source>
        <translation>거기서 깊이(%1)는 저장된 %2보다 크지 않습니다. 어느 표본에서도 더 가깝지 않습니다.</translation>
    </message>
    <message>
        <source>At %1 samples it is nearer, at %2 of them the first surface. There its depth %3 exceeds the stored %4: drawn.</source>
        <translation>표본 %1개에서 더 가깝고, 그중 %2개에서는 첫 번째 면입니다. 거기서 깊이(%3)가 저장된 %4보다 큽니다: 그립니다.</translation>
    </message>
    <message>
        <source>Columns %1 to %2 are filled with it.</source>
        <translation>%1열부터 %2열까지 이 면으로 채웁니다.</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden beyond α = 90°, drawn within it.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: S %1 ≤ 그 앞의 최댓값 %2. α = 90° 너머는 가려지고, 그 안쪽은 그립니다.</translation>
    </message>
    <message>
        <source>About rows of the picture</source>
        <translation>그림의 행에 관한 것</translation>
    </message>
    <message>
        <source>About triangles</source>
        <translation>삼각형에 관한 것</translation>
    </message>
    <message>
        <source>Rows %1 of the picture</source>
        <translation>그림의 %1행</translation>
    </message>
    <message>
        <source>Row %1 of the picture</source>
        <translation>그림의 %1행</translation>
    </message>
    <message>
        <source>Triangle %1</source>
        <translation>삼각형 %1</translation>
    </message>
    <message>
        <source>Triangles %1 of %2</source>
        <translation>%2의 삼각형 %1</translation>
    </message>
    <message>
        <source>Triangle %1 of %2</source>
        <translation>%2의 삼각형 %1</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>구</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>원기둥</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>원뿔</translation>
    </message>
    <message>
        <source>eccentric cone</source>
        <translation>편심 원뿔</translation>
    </message>
    <message>
        <source>mitred cylinder</source>
        <translation>사선 절단 원기둥</translation>
    </message>
    <message>
        <source>circular torus</source>
        <translation>원형 단면 토러스</translation>
    </message>
    <message>
        <source>rectangular torus</source>
        <translation>사각 단면 토러스</translation>
    </message>
    <message>
        <source>ellipsoidal dish</source>
        <translation>타원체 경판</translation>
    </message>
    <message>
        <source>spherical dish</source>
        <translation>구형 경판</translation>
    </message>
    <message>
        <source>torispherical head</source>
        <translation>접시형 경판</translation>
    </message>
    <message>
        <source>box</source>
        <translation>직육면체</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>쐐기</translation>
    </message>
    <message>
        <source>pyramid</source>
        <translation>각뿔</translation>
    </message>
    <message>
        <source>frustum of a pyramid</source>
        <translation>각뿔대</translation>
    </message>
    <message>
        <source>prism</source>
        <translation>각기둥</translation>
    </message>
    <message>
        <source>disc</source>
        <translation>원판</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>고리</translation>
    </message>
    <message>
        <source>hollow cylinder</source>
        <translation>속 빈 원기둥</translation>
    </message>
    <message>
        <source>%1: of these sizes it has no surface, but is a point or a line.</source>
        <translation>%1: 이 크기로는 면이 없고 점이나 선이 됩니다.</translation>
    </message>
    <message>
        <source>%1: its lengths are numbers from 0 to 1e30.</source>
        <translation>%1: 길이는 0에서 1e30 사이의 수여야 합니다.</translation>
    </message>
    <message>
        <source>%1: its angle is more than 0 and at most 360 degrees.</source>
        <translation>%1: 각도는 0보다 크고 360도 이하여야 합니다.</translation>
    </message>
    <message>
        <source>%1: its inner radius is smaller than its outer one.</source>
        <translation>%1: 안쪽 반지름은 바깥쪽 반지름보다 작아야 합니다.</translation>
    </message>
    <message>
        <source>%1: its ends are cut at less than 90 degrees.</source>
        <translation>%1: 양 끝은 90도보다 작은 각도로 잘려야 합니다.</translation>
    </message>
    <message>
        <source>%1: its slanted ends do not cut each other. Make it longer or cut it less.</source>
        <translation>%1: 비스듬한 양 끝이 서로 만나서는 안 됩니다. 더 길게 하거나 덜 자르십시오.</translation>
    </message>
    <message>
        <source>%1: its tube is no thicker than its ring allows.</source>
        <translation>%1: 관이 고리가 허용하는 것보다 굵을 수 없습니다.</translation>
    </message>
    <message>
        <source>%1: its crown is at least as wide as its vessel, and its knuckle at most.</source>
        <translation>%1: 크라운은 용기 반지름 이상, 너클은 용기 반지름 이하여야 합니다.</translation>
    </message>
    <message>
        <source>%1: it has 3 to 1000 sides.</source>
        <translation>%1: 옆면은 3개에서 1000개까지입니다.</translation>
    </message>
    <message>
        <source>facet group</source>
        <translation>면 모음</translation>
    </message>
    <message>
        <source>line</source>
        <translation>선</translation>
    </message>
    <message>
        <source>Generating the plant</source>
        <translation>플랜트를 만드는 중</translation>
    </message>
    <message>
        <source>%1, byte %2: an RVM file begins with a record HEAD.</source>
        <translation>%1, %2번째 바이트: RVM 파일은 HEAD 레코드로 시작합니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the record MODL is missing after HEAD.</source>
        <translation>%1, %2번째 바이트: HEAD 다음에 MODL 레코드가 없습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the record &quot;%3&quot; is unknown. Export the file again.</source>
        <translation>%1, %2번째 바이트: &quot;%3&quot; 레코드를 알 수 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: the file ends within a group.</source>
        <translation>%1, %2번째 바이트: 파일이 그룹 안에서 끝납니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the record %3 is too short for what it holds.</source>
        <translation>%1, %2번째 바이트: %3 레코드가 담긴 내용에 비해 짧습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the file breaks off within a record. Fetch or export it again.</source>
        <translation>%1, %2번째 바이트: 파일이 레코드 중간에서 끊깁니다. 다시 받거나 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: here is no number but an infinity or NaN.</source>
        <translation>%1, %2번째 바이트: 수가 아니라 무한대나 NaN이 있습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: here is a text of %3 words, too long to be one.</source>
        <translation>%1, %2번째 바이트: 여기 텍스트의 길이가 %3워드로, 텍스트라기에는 너무 깁니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: here are to be %3 items, more than the record has room for.</source>
        <translation>%1, %2번째 바이트: 항목이 %3개라고 하지만 레코드에 그만한 자리가 없습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the file breaks off before its record END.</source>
        <translation>%1, %2번째 바이트: 파일이 END 레코드 앞에서 끊깁니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: no record of an RVM file begins here.</source>
        <translation>%1, %2번째 바이트: 여기서 시작하는 RVM 레코드가 없습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: the next record is said to begin at byte %3, which is not after this one in the file.</source>
        <translation>%1, %2번째 바이트: 다음 레코드가 %3번째 바이트에서 시작한다고 하지만, 그곳은 파일 안에서 이 레코드 뒤가 아닙니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: groups lie deeper in each other than %3.</source>
        <translation>%1, %2번째 바이트: 그룹이 %3단계보다 깊이 들어 있습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: a group ends that has not begun.</source>
        <translation>%1, %2번째 바이트: 시작하지 않은 그룹이 끝납니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: there is no primitive of kind %3.</source>
        <translation>%1, %2번째 바이트: 종류가 %3인 기본 입체는 없습니다.</translation>
    </message>
    <message>
        <source>%1, byte %2: a primitive lies outside of all groups.</source>
        <translation>%1, %2번째 바이트: 기본 입체가 어느 그룹에도 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>%1 holds no surface. Export the plant with its primitives.</source>
        <translation>%1에 면이 없습니다. 플랜트를 기본 입체와 함께 내보내십시오.</translation>
    </message>
    <message>
        <source>Primitives left out because no such solid exists: %1. The first, at byte %2: %3</source>
        <translation>그런 입체가 있을 수 없어 뺀 기본 입체: %1개. 첫 번째는 %2번째 바이트: %3</translation>
    </message>
    <message>
        <source>Its transform is flat.</source>
        <translation>변환이 납작합니다.</translation>
    </message>
    <message>
        <source>It lies beyond 1e30.</source>
        <translation>1e30 너머에 있습니다.</translation>
    </message>
    <message>
        <source>a process plant of primitives: pipe racks with pipelines, equipment, steel and platforms</source>
        <translation>기본 입체로 된 공정 플랜트: 배관이 놓인 파이프 랙, 기기, 철골, 플랫폼</translation>
    </message>
    <message>
        <source>how many pipelines</source>
        <translation>배관의 수</translation>
    </message>
    <message>
        <source>number that the plant starts from</source>
        <translation>플랜트를 만드는 시작 수</translation>
    </message>
    <message>
        <source>for batches of spheres, then of boxes</source>
        <translation>구들을 묶음으로, 다음에 상자들을</translation>
    </message>
    <message>
        <source>for each plane, until all are outside</source>
        <translation>모두 밖일 때까지, 평면마다</translation>
    </message>
    <message>
        <source>d = how far each one reaches in</source>
        <translation>d = 각각 안쪽으로 들어온 거리</translation>
    </message>
    <message>
        <source>outside: those with d &lt; −margin</source>
        <translation>밖: d &lt; −한계인 것</translation>
    </message>
    <message>
        <source>the first %1 nodes alone</source>
        <translation>처음 %1개 노드만</translation>
    </message>
    <message>
        <source>The farthest depth %4 of triangle %2 does not exceed the nearest depth %3 of triangle %1: it lies nearer, and so do all after it.</source>
        <translation>삼각형 %2의 가장 먼 깊이(%4)는 삼각형 %1의 가장 가까운 깊이(%3)를 넘지 않습니다. 이 삼각형과 그 뒤의 모든 삼각형이 더 가깝습니다.</translation>
    </message>
    <message>
        <source>The farthest depth %4 of triangle %2 exceeds the nearest depth %3 of triangle %1: they overlap in depth.</source>
        <translation>삼각형 %2의 가장 먼 깊이(%4)는 삼각형 %1의 가장 가까운 깊이(%3)를 넘습니다. 깊이가 겹칩니다.</translation>
    </message>
    <message>
        <source>Test 1: in x triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.</source>
        <translation>검사 1: x 방향으로 %1 삼각형은 픽셀 %3에서, %2 삼각형은 %4에서 끝납니다. 떨어져 있습니다.</translation>
    </message>
    <message>
        <source>Test 1: in x both triangles %1 and %2 have the pixels from %3 to %4: not apart.</source>
        <translation>검사 1: x 방향으로 %1 삼각형과 %2 삼각형이 모두 픽셀 %3부터 %4까지 차지합니다. 떨어져 있지 않습니다.</translation>
    </message>
    <message>
        <source>Test 2: in y triangle %1 ends at pixel %3 and triangle %2 at %4: they are apart.</source>
        <translation>검사 2: y 방향으로 %1 삼각형은 픽셀 %3에서, %2 삼각형은 %4에서 끝납니다. 떨어져 있습니다.</translation>
    </message>
    <message>
        <source>Test 2: in y both triangles %1 and %2 have the pixels from %3 to %4: not apart.</source>
        <translation>검사 2: y 방향으로 %1 삼각형과 %2 삼각형이 모두 픽셀 %3부터 %4까지 차지합니다. 떨어져 있지 않습니다.</translation>
    </message>
    <message>
        <source>Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and %4 behind it: it lies wholly behind.</source>
        <translation>검사 3: 눈에서 볼 때 %1 삼각형은 삼각형 %2의 평면 앞으로 %3, 뒤로 %4만큼 뻗습니다. 온전히 뒤에 있습니다.</translation>
    </message>
    <message>
        <source>Test 3: triangle %1 reaches %3 before the plane of triangle %2, seen from the eye, and %4 behind it: it does not lie wholly behind.</source>
        <translation>검사 3: 눈에서 볼 때 %1 삼각형은 삼각형 %2의 평면 앞으로 %3, 뒤로 %4만큼 뻗습니다. 온전히 뒤에 있지는 않습니다.</translation>
    </message>
    <message>
        <source>Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and %4 behind it: it lies wholly before.</source>
        <translation>검사 4: 눈에서 볼 때 %2 삼각형은 삼각형 %1의 평면 앞으로 %3, 뒤로 %4만큼 뻗습니다. 온전히 앞에 있습니다.</translation>
    </message>
    <message>
        <source>Test 4: triangle %2 reaches %3 before the plane of triangle %1, seen from the eye, and %4 behind it: it does not lie wholly before.</source>
        <translation>검사 4: 눈에서 볼 때 %2 삼각형은 삼각형 %1의 평면 앞으로 %3, 뒤로 %4만큼 뻗습니다. 온전히 앞에 있지는 않습니다.</translation>
    </message>
    <message>
        <source>No test lets triangle %1, with the farthest depth %3, come before triangle %2, with %4: the second one is taken first.</source>
        <translation>어느 검사로도 가장 먼 깊이가 %3인 %1 삼각형이 가장 먼 깊이가 %4인 삼각형 %2보다 먼저 올 수 없습니다. 뒤의 것을 먼저 다룹니다.</translation>
    </message>
    <message>
        <source>Triangle %1, with the farthest depth %3, waits for triangle %2, with %4, which is marked: a cycle, in which one is cut.</source>
        <translation>가장 먼 깊이가 %3인 %1 삼각형은 표시된 %2 삼각형(가장 먼 깊이 %4)을 기다립니다. 순환이므로 하나를 자릅니다.</translation>
    </message>
    <message>
        <source>Triangles %1 and %2 pass through each other: 1 / depth of the first less that of the second goes from %3 to %4. One of them is cut.</source>
        <translation>%1 삼각형과 %2 삼각형은 서로 뚫고 지나갑니다. 앞의 것의 1/깊이에서 뒤의 것의 1/깊이를 뺀 값은 %3부터 %4까지입니다. 하나를 자릅니다.</translation>
    </message>
    <message>
        <source>Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less that of the second goes from %3 to %4: it is nowhere nearer.</source>
        <translation>검사 5: %1 삼각형과 %2 삼각형의 투영이 겹치는 곳에서 앞의 것의 1/깊이에서 뒤의 것의 1/깊이를 뺀 값은 %3부터 %4까지입니다. 앞의 것은 어디에서도 더 가깝지 않습니다.</translation>
    </message>
    <message>
        <source>Test 5: where the projections of triangles %1 and %2 overlap, 1 / depth of the first less that of the second goes from %3 to %4: it is nearer somewhere.</source>
        <translation>검사 5: %1 삼각형과 %2 삼각형의 투영이 겹치는 곳에서 앞의 것의 1/깊이에서 뒤의 것의 1/깊이를 뺀 값은 %3부터 %4까지입니다. 앞의 것이 어딘가에서 더 가깝습니다.</translation>
    </message>
    <message>
        <source>Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, not by more than %4: they count as apart.</source>
        <translation>검사 5: %1 삼각형과 %2 삼각형의 투영은 %3픽셀 겹칩니다. 한도(%4)를 넘지 않으므로 떨어진 것으로 봅니다.</translation>
    </message>
    <message>
        <source>Test 5: the projections of triangles %1 and %2 overlap by %3 pixels, by more than %4: not apart.</source>
        <translation>검사 5: %1 삼각형과 %2 삼각형의 투영은 %3픽셀 겹칩니다. 한도(%4)를 넘으므로 떨어져 있지 않습니다.</translation>
    </message>
    <message>
        <source>drawn polygons alone, above %1 triangles</source>
        <translation>삼각형이 %1개를 넘어 그린 다각형만</translation>
    </message>
    <message>
        <source>without depths and tests 1 and 2, above %1 triangles</source>
        <translation>삼각형이 %1개를 넘어 깊이 비교와 검사 1, 2 생략</translation>
    </message>
    <message>
        <source>the first %1 tests alone</source>
        <translation>처음 %1개 검사만</translation>
    </message>
    <message>
        <source>the first %1 polygons alone</source>
        <translation>처음 %1개 다각형만</translation>
    </message>
    <message>
        <source>Colours by verdict</source>
        <translation>판정별 색</translation>
    </message>
    <message>
        <source>Colours by &amp;verdict</source>
        <translation>판정별 색(&amp;V)</translation>
    </message>
    <message>
        <source>Colour the active view by what became of each triangle</source>
        <translation>각 삼각형이 어떻게 되었는지에 따라 활성 뷰를 칠합니다</translation>
    </message>
    <message>
        <source>With verdicts, what was left out too</source>
        <translation>판정 색에서 제외된 것도 표시</translation>
    </message>
    <message>
        <source>The culling camera&apos;s frustum</source>
        <translation>컬링 카메라의 절두체</translation>
    </message>
    <message>
        <source>F&amp;rustum</source>
        <translation>절두체(&amp;R)</translation>
    </message>
    <message>
        <source>Show the culling camera&apos;s frustum in the active view</source>
        <translation>활성 뷰에 컬링 카메라의 절두체를 표시합니다</translation>
    </message>
    <message>
        <source>The boxes that were tested</source>
        <translation>검사한 상자</translation>
    </message>
    <message>
        <source>&amp;Boxes</source>
        <translation>상자(&amp;B)</translation>
    </message>
    <message>
        <source>Show the boxes that the strategy tested in the active view</source>
        <translation>전략이 검사한 상자를 활성 뷰에 표시합니다</translation>
    </message>
    <message>
        <source>Boxes by the plane that rejected them</source>
        <translation>제외한 평면별 상자</translation>
    </message>
    <message>
        <source>Boxes by rejecting &amp;plane</source>
        <translation>제외한 평면별 상자(&amp;P)</translation>
    </message>
    <message>
        <source>Show the boxes in the active view in the colour of the plane of the frustum that rejected them; the frustum&apos;s planes have the same colours</source>
        <translation>활성 뷰의 상자를 그것을 제외한 절두체 평면의 색으로 보입니다. 절두체의 평면도 같은 색입니다</translation>
    </message>
    <message>
        <source>Model in spherical coordinates</source>
        <translation>구좌표계로 나타낸 모델</translation>
    </message>
    <message>
        <source>Model in &amp;spherical coordinates</source>
        <translation>구좌표계로 나타낸 모델(&amp;S)</translation>
    </message>
    <message>
        <source>Show what was drawn of one object over azimuth and zenith angle in the active view</source>
        <translation>활성 뷰에서 한 물체의 그려진 부분을 방위각과 고도각 위에 표시합니다</translation>
    </message>
    <message>
        <source>Components by occupancy value</source>
        <translation>점유값별 구성 요소</translation>
    </message>
    <message>
        <source>octrees</source>
        <translation>옥트리</translation>
    </message>
    <message>
        <source>Largest value %1 ÷ distance %2 = %3 &lt; %4: its components count as too small.</source>
        <translation>최댓값 %1 ÷ 거리 %2 = %3 &lt; %4: 구성 요소를 너무 작은 것으로 봅니다.</translation>
    </message>
    <message>
        <source>Largest value %1 ÷ distance %2 = %3 ≥ %4: its components are drawn.</source>
        <translation>최댓값 %1 ÷ 거리 %2 = %3 ≥ %4: 구성 요소를 그립니다.</translation>
    </message>
    <message>
        <source>The camera rests: %1 components of the outline and %2 others, none of them too small.</source>
        <translation>카메라가 멈춰 있습니다: 윤곽의 구성 요소 %1개와 나머지 %2개 중 너무 작은 것은 없습니다.</translation>
    </message>
    <message>
        <source>%1 components of the outline are in octree L, %2 others in octree S.</source>
        <translation>윤곽의 구성 요소 %1개는 옥트리 L에, 나머지 %2개는 옥트리 S에 있습니다.</translation>
    </message>
    <message>
        <source>The component &quot;%1&quot; has %2 triangles; it is drawn with its leaf or not at all.</source>
        <translation>구성 요소 &quot;%1&quot;의 삼각형은 %2개이며, 잎과 함께 그리거나 그리지 않습니다.</translation>
    </message>
    <message>
        <source>It lies in a leaf of %1 components, which is drawn as a whole.</source>
        <translation>구성 요소 %1개의 잎에 있으며, 이 잎은 통째로 그립니다.</translation>
    </message>
    <message>
        <source>Octree %1: %2 components</source>
        <translation>옥트리 %1: 구성 요소 %2개</translation>
    </message>
    <message>
        <source>for each node of octrees L and S</source>
        <translation>옥트리 L과 S의 각 노드에 대해</translation>
    </message>
    <message>
        <source>test its box against the six planes</source>
        <translation>상자를 여섯 평면과 검사</translation>
    </message>
    <message>
        <source>outside: leave its components out</source>
        <translation>밖: 구성 요소를 제외</translation>
    </message>
    <message>
        <source>leaf of L: draw its components</source>
        <translation>L의 잎: 구성 요소를 그림</translation>
    </message>
    <message>
        <source>leaf of S: t = value ÷ distance</source>
        <translation>S의 잎: t = 값 ÷ 거리</translation>
    </message>
    <message>
        <source>if t &lt; k′·tan θ: leave it out</source>
        <translation>t &lt; k′·tan θ이면 제외</translation>
    </message>
    <message>
        <source>else draw its components</source>
        <translation>아니면 구성 요소를 그림</translation>
    </message>
    <message>
        <source>How many of the components, the largest ones, are the outline, which is always drawn. The paper names no number.</source>
        <translation>구성 요소 중 가장 큰 것들의 비율로, 윤곽이 되어 항상 그립니다. 논문에는 값이 없습니다.</translation>
    </message>
    <message>
        <source>A leaf is left out where its largest occupancy value, divided by its distance, is below this: k′·tan θ.</source>
        <translation>잎의 가장 큰 점유값을 거리로 나눈 값이 이보다 작으면 제외합니다: k′·tan θ.</translation>
    </message>
    <message>
        <source>Levels of octree L, which holds the outline; the root is one of them.</source>
        <translation>윤곽을 담는 옥트리 L의 단계 수(루트 포함).</translation>
    </message>
    <message>
        <source>Levels of octree S, which holds the details; the root is one of them.</source>
        <translation>세부를 담는 옥트리 S의 단계 수(루트 포함).</translation>
    </message>
    <message>
        <source>Which box of a node is tested and has the distance; the paper can be read both ways.</source>
        <translation>노드의 어느 상자를 검사하고 거리를 재는지. 논문은 두 가지로 읽힙니다.</translation>
    </message>
    <message>
        <source>the box around its components</source>
        <translation>구성 요소를 둘러싼 상자</translation>
    </message>
    <message>
        <source>the octree&apos;s cell, over which components reach</source>
        <translation>옥트리의 셀(구성 요소가 넘어설 수 있음)</translation>
    </message>
    <message>
        <source>What is drawn while the camera does not move.</source>
        <translation>카메라가 움직이지 않을 때 그리는 것.</translation>
    </message>
    <message>
        <source>the same as in motion</source>
        <translation>움직일 때와 같음</translation>
    </message>
    <message>
        <source>everything in the frustum, as in the paper&apos;s Figure 8</source>
        <translation>논문의 그림 8처럼 절두체 안의 모든 것</translation>
    </message>
    <message>
        <source>Small-feature culling</source>
        <translation>작은 형상 컬링</translation>
    </message>
    <message>
        <source>Leaves out groups of components that are too small for their distance; a plant&apos;s outline stays.</source>
        <translation>거리에 비해 너무 작은 구성 요소 그룹을 제외합니다. 플랜트의 윤곽은 남습니다.</translation>
    </message>
    <message>
        <source>components</source>
        <translation>구성 요소</translation>
    </message>
    <message>
        <source>Its box covers at most %1 pixels, no more than the %2 that may be lost.</source>
        <translation>상자가 덮는 픽셀은 많아야 %1개로, 잃어도 되는 %2개를 넘지 않습니다.</translation>
    </message>
    <message>
        <source>Its box covers up to %1 pixels, more than the %2 that may be lost.</source>
        <translation>상자가 덮는 픽셀은 %1개까지로, 잃어도 되는 %2개보다 많습니다.</translation>
    </message>
    <message>
        <source>With the small components of its group it covers at most %1 pixels, no more than the %2 that may be lost.</source>
        <translation>그룹의 작은 구성 요소들과 함께 덮는 픽셀은 많아야 %1개로, 잃어도 되는 %2개를 넘지 않습니다.</translation>
    </message>
    <message>
        <source>With the small components of its group it covers up to %1 pixels, more than the %2 that may be lost.</source>
        <translation>그룹의 작은 구성 요소들과 함께 덮는 픽셀은 %1개까지로, 잃어도 되는 %2개보다 많습니다.</translation>
    </message>
    <message>
        <source>Its box covers at most %1 pixels; %2 may be lost of a group.</source>
        <translation>상자가 덮는 픽셀은 많아야 %1개이고, 한 그룹에서 %2개를 잃어도 됩니다.</translation>
    </message>
    <message>
        <source>Of the component &quot;%1&quot; with %2 triangles the pixels that its box covers are counted.</source>
        <translation>삼각형 %2개인 구성 요소 &quot;%1&quot;의 상자가 덮는 픽셀을 셉니다.</translation>
    </message>
    <message>
        <source>It lies in a group of %1 components, which covers too many pixels to be left out as a whole.</source>
        <translation>구성 요소 %1개의 그룹에 있으며, 이 그룹은 통째로 제외하기에는 너무 많은 픽셀을 덮습니다.</translation>
    </message>
    <message>
        <source>for each group: planes and axes</source>
        <translation>각 그룹에 대해: 평면과 축</translation>
    </message>
    <message>
        <source>n = pixels that its box covers</source>
        <translation>n = 상자가 덮는 픽셀 수</translation>
    </message>
    <message>
        <source>if n ≤ pixels: leave the group out</source>
        <translation>n ≤ pixels이면 그룹을 제외</translation>
    </message>
    <message>
        <source>for each component: n of its box</source>
        <translation>각 구성 요소: 상자의 n</translation>
    </message>
    <message>
        <source>if n = 0: leave it out</source>
        <translation>n = 0이면 제외</translation>
    </message>
    <message>
        <source>if n ≤ pixels: it is a small one</source>
        <translation>n ≤ pixels이면 작은 것</translation>
    </message>
    <message>
        <source>small ones&apos; sum ≤ pixels: leave out</source>
        <translation>작은 것의 합 ≤ pixels: 제외</translation>
    </message>
    <message>
        <source>draw the others, nearest first</source>
        <translation>나머지를 가까운 것부터 그림</translation>
    </message>
    <message>
        <source>How many pixels a group of components may lose. With 0 nothing visible is lost.</source>
        <translation>구성 요소 그룹이 잃어도 되는 픽셀 수. 0이면 보이는 것을 잃지 않습니다.</translation>
    </message>
    <message>
        <source>Bounded small-feature culling</source>
        <translation>한계가 있는 작은 형상 컬링</translation>
    </message>
    <message>
        <source>Leaves out small components where the pixels that a group may lose by it stay under a bound.</source>
        <translation>한 그룹이 잃을 수 있는 픽셀이 한계 아래인 곳에서 작은 구성 요소를 제외합니다.</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box, then each of its %2 triangles by its size.</source>
        <translation>&quot;%1&quot; 물체를 상자 하나로 검사한 뒤, 삼각형 %2개를 하나씩 크기로 검사합니다.</translation>
    </message>
    <message>
        <source>Of %1 triangles %2 have half a longest edge below %3 of their distance: too small.</source>
        <translation>삼각형 %1개 중 %2개는 가장 긴 변의 절반이 거리의 %3보다 작습니다: 너무 작음.</translation>
    </message>
    <message>
        <source>Its %1 triangles are decided together: the least ratio that any of them can have is %2, no less than %3.</source>
        <translation>삼각형 %1개를 함께 결정합니다. 어느 삼각형이든 가질 수 있는 가장 작은 비가 %2로, %3보다 작지 않습니다.</translation>
    </message>
    <message>
        <source>Its %1 triangles are decided together: the largest ratio that any of them can have is %2, below %3: too small.</source>
        <translation>삼각형 %1개를 함께 결정합니다. 어느 삼각형이든 가질 수 있는 가장 큰 비가 %2로, %3보다 작습니다: 너무 작음.</translation>
    </message>
    <message>
        <source>else its parts, then each object</source>
        <translation>아니면 부분들, 그다음 각 물체</translation>
    </message>
    <message>
        <source>for each triangle of those kept</source>
        <translation>남은 것의 각 삼각형에 대해</translation>
    </message>
    <message>
        <source>t = ½ longest edge ÷ distance</source>
        <translation>t = ½ 가장 긴 변 ÷ 거리</translation>
    </message>
    <message>
        <source>draw those with t ≥ threshold</source>
        <translation>t ≥ threshold인 것을 그림</translation>
    </message>
    <message>
        <source>A triangle is left out where half its longest edge, divided by its distance, is below this.</source>
        <translation>가장 긴 변의 절반을 거리로 나눈 값이 이보다 작은 삼각형을 제외합니다.</translation>
    </message>
    <message>
        <source>Small-feature culling by triangle</source>
        <translation>삼각형별 작은 형상 컬링</translation>
    </message>
    <message>
        <source>Leaves out every triangle that is too small for its distance: the traditional way.</source>
        <translation>거리에 비해 너무 작은 삼각형을 모두 제외합니다: 전통적인 방법.</translation>
    </message>
    <message>
        <source>by bands of rows, above %1 triangles</source>
        <translation>삼각형이 %1개를 넘어 행의 띠별</translation>
    </message>
    <message>
        <source>by bands of rows, above %1 pixels to look at</source>
        <translation>살펴볼 픽셀이 %1개를 넘어 행의 띠별</translation>
    </message>
    <message>
        <source>In these rows %1 depths were compared with the stored ones; %2 were nearer and stored. %3 pixels show a surface.</source>
        <translation>이 행들에서 깊이 %1개를 저장된 깊이와 비교함. %2개가 더 가까워 저장됨. 픽셀 %3개에 면이 보입니다.</translation>
    </message>
    <message>
        <source>causes by object, above %1 groups of triangles</source>
        <translation>삼각형 묶음이 %1개를 넘어 원인은 물체별</translation>
    </message>
    <message>
        <source>by row, above %1 spans</source>
        <translation>스팬이 %1개를 넘어 행별</translation>
    </message>
    <message>
        <source>without single edges, above %1 of them</source>
        <translation>변이 %1개를 넘어 낱개 생략</translation>
    </message>
    <message>
        <source>An edge of it is active: in row %1 it lies at x = %2, and the triangle begins at column %3.</source>
        <translation>이 삼각형의 변이 활성입니다: %1행에서 x = %2에 있고, 삼각형은 %3열에서 시작합니다.</translation>
    </message>
    <message>
        <source>An edge of it is active: in row %1 it lies at x = %2, and the triangle ends before column %3.</source>
        <translation>이 삼각형의 변이 활성입니다: %1행에서 x = %2에 있고, 삼각형은 %3열 앞에서 끝납니다.</translation>
    </message>
    <message>
        <source>results alone, above %1 objects</source>
        <translation>물체가 %1개를 넘어 결과만</translation>
    </message>
    <message>
        <source>It is left out with its whole group (objects: %1): %2.</source>
        <translation>그룹 전체와 함께 제외됩니다(물체 %1개): %2.</translation>
    </message>
    <message>
        <source>What lies in a plane hangs at the plane&apos;s node, in a row &quot;in&quot; with the plane&apos;s name.</source>
        <translation>평면에 놓인 것은 그 평면의 노드에 달리며, 평면 이름이 붙은 &quot;in&quot; 행에 있습니다.</translation>
    </message>
    <message>
        <source>The paper&apos;s plants are not to be had, and its tables did not survive: here are generated plants of as many pipelines. Of its figures only the conclusion is left, at least 200 % more frames than by triangle.</source>
        <translation>논문의 플랜트는 구할 수 없고 표도 남아 있지 않습니다. 여기서는 배관 수가 같은 생성된 플랜트를 씁니다. 수치는 결론만 남아 있습니다: 삼각형별 방법보다 프레임이 200 % 이상 많습니다.</translation>
    </message>
    <message>
        <source>The views are of a walk through the plant at half its height, 30° across as in the paper.</source>
        <translation>뷰는 플랜트 높이의 절반에서 그 안을 지나는 보행의 것이며, 논문처럼 가로 시야가 30°입니다.</translation>
    </message>
    <message>
        <source>The paper tests every triangle of the plant at every frame. Here small-feature-triangle has the frustum, groups, vector units and every core on its side. Its missed pixels stand beside its time.</source>
        <translation>논문은 매 프레임 플랜트의 모든 삼각형을 검사합니다. 여기서 small-feature-triangle은 절두체, 그룹, 벡터 연산, 모든 코어의 도움을 받습니다. 놓친 픽셀은 시간 옆에 있습니다.</translation>
    </message>
    <message>
        <source>Groups, sizes and draw list are stages of culling: the tests of octrees, those of triangles or components by their size, and the list of what is drawn.</source>
        <translation>그룹, 크기, 그리기 목록은 컬링의 단계입니다: 옥트리의 검사, 삼각형이나 구성 요소의 크기 검사, 그릴 것의 목록.</translation>
    </message>
    <message>
        <source>pipelines</source>
        <translation>배관</translation>
    </message>
    <message>
        <source>Small-feature culling of process plants, by method</source>
        <translation>공정 플랜트의 작은 형상 컬링: 방법별</translation>
    </message>
    <message>
        <source>Small-feature culling by the number of pipelines</source>
        <translation>배관 수에 따른 작은 형상 컬링</translation>
    </message>
    <message>
        <source>Culling by visible leaves</source>
        <translation>보이는 잎에 따른 컬링</translation>
    </message>
    <message>
        <source>visible leaves</source>
        <translation>보이는 잎</translation>
    </message>
    <message>
        <source>groups, ms</source>
        <translation>그룹, ms</translation>
    </message>
    <message>
        <source>Frames per second by pipelines</source>
        <translation>배관 수에 따른 초당 프레임</translation>
    </message>
    <message>
        <source>Culling by pipelines</source>
        <translation>배관 수에 따른 컬링</translation>
    </message>
    <message>
        <source>culling, ms</source>
        <translation>컬링, ms</translation>
    </message>
    <message>
        <source>Loss of small-feature culling by its threshold</source>
        <translation>임계값에 따른 작은 형상 컬링의 손실</translation>
    </message>
    <message>
        <source>A threshold of so many pixels is the side of a square. It is k′·tan θ of small-feature and small-feature-triangle, with the paper&apos;s field of view of 30°; small-feature-bounded may lose as many pixels of a group as the square has.</source>
        <translation>픽셀 임계값은 정사각형의 한 변입니다. small-feature와 small-feature-triangle에서는 논문의 시야 30°로 계산한 k′·tan θ이고, small-feature-bounded는 한 그룹에서 그 정사각형의 픽셀 수만큼 잃을 수 있습니다.</translation>
    </message>
    <message>
        <source>threshold, px</source>
        <translation>임계값, 픽셀</translation>
    </message>
    <message>
        <source>Speed by threshold: %1</source>
        <translation>임계값에 따른 속도: %1</translation>
    </message>
    <message>
        <source>× frustum-octree</source>
        <translation>× frustum-octree</translation>
    </message>
    <message>
        <source>Loss by threshold: %1</source>
        <translation>임계값에 따른 손실: %1</translation>
    </message>
    <message>
        <source>sizes, ms</source>
        <translation>크기, ms</translation>
    </message>
    <message>
        <source>draw list, ms</source>
        <translation>그리기 목록, ms</translation>
    </message>
    <message>
        <source>triangles a pipeline</source>
        <translation>배관당 삼각형</translation>
    </message>
    <message>
        <source>components a pipeline</source>
        <translation>배관당 구성 요소</translation>
    </message>
    <message>
        <source>frame, ms</source>
        <translation>프레임, ms</translation>
    </message>
    <message>
        <source>× frustum-octree [95 %]</source>
        <translation>× frustum-octree [95 %]</translation>
    </message>
    <message>
        <source>paper: × by triangle, at least</source>
        <translation>논문: 삼각형별 방법의 ×, 최소</translation>
    </message>
    <message>
        <source>× by triangle [95 %]</source>
        <translation>× 삼각형별 방법 [95 %]</translation>
    </message>
    <message>
        <source>stated, at most, px</source>
        <translation>명시한 최대 손실, 픽셀</translation>
    </message>
    <message>
        <source>missed less stated, px</source>
        <translation>놓친 픽셀 − 명시한 값</translation>
    </message>
    <message>
        <source>drawing, ms</source>
        <translation>그리기, ms</translation>
    </message>
    <message>
        <source>bytes of the scene</source>
        <translation>장면의 바이트</translation>
    </message>
    <message>
        <source>Making levels of detail</source>
        <translation>세부 단계를 만드는 중</translation>
    </message>
    <message>
        <source>%1 polygons are sorted by the distance of their centroids alone. None are compared.</source>
        <translation>폴리곤 %1개를 무게중심의 거리로만 정렬함. 서로 비교하지 않습니다.</translation>
    </message>
    <message>
        <source>sort far first, by depth or centroid</source>
        <translation>먼 것부터 정렬: 깊이 또는 무게중심</translation>
    </message>
    <message>
        <source>no Q left, or none compared: draw P</source>
        <translation>남은 Q 없음/비교 안 함: P 그리기</translation>
    </message>
    <message>
        <source>Triangle %2 covers no sample and is compared with none: %1 of its area is drawn.</source>
        <translation>삼각형 %2는 표본을 덮지 않아 아무것과도 비교하지 않음: 그 면적의 %1을 그립니다.</translation>
    </message>
    <message>
        <source>Because of rounding alone triangle %2 still waits for others, and none of them can be cut: %1 of its area is drawn all the same.</source>
        <translation>반올림만으로 삼각형 %2가 아직 다른 것을 기다리고 자를 수 있는 것이 없음: 그래도 그 면적의 %1을 그립니다.</translation>
    </message>
    <message>
        <source>Of its levels 0 to %1, level %2 moves its surface by at most %3 of %4 pixels.</source>
        <translation>단계 0~%1 가운데 %2번 단계는 표면을 많아야 %3픽셀 움직입니다(허용 %4픽셀).</translation>
    </message>
    <message>
        <source>Level %1 would do with %2 pixels; it changes to a coarser level only below %3.</source>
        <translation>단계 %1도 %2픽셀로 충분하지만, 더 거친 단계로는 %3픽셀 아래에서만 바뀝니다.</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; has %2 triangles; far away, a coarser level stands for it.</source>
        <translation>물체 &quot;%1&quot;에는 삼각형이 %2개 있습니다. 멀리서는 더 거친 단계가 그것을 대신합니다.</translation>
    </message>
    <message>
        <source>k = coarsest: e·f ÷ z ≤ error</source>
        <translation>k = 가장 거친 것: e·f ÷ z ≤ error</translation>
    </message>
    <message>
        <source>coarser than last: ≤ (1−h)·error</source>
        <translation>앞보다 거칠면: ≤ (1−h)·error</translation>
    </message>
    <message>
        <source>draw level k, nearest first</source>
        <translation>단계 k를 가까운 것부터 그립니다</translation>
    </message>
    <message>
        <source>By how many pixels a coarser level may move an object&apos;s surface in the picture.</source>
        <translation>더 거친 단계가 그림에서 물체의 표면을 움직여도 되는 픽셀 수.</translation>
    </message>
    <message>
        <source>By what share of these pixels a coarser level must stay below them before an object changes to it: against popping.</source>
        <translation>물체가 더 거친 단계로 바뀌려면 그 단계가 이 픽셀 수보다 얼마만큼의 비율로 더 작아야 하는지: 튀는 현상을 막습니다.</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>세부 단계</translation>
    </message>
    <message>
        <source>Draws far objects with fewer triangles, whose surfaces move by a bounded number of pixels.</source>
        <translation>멀리 있는 물체를 더 적은 삼각형으로 그립니다. 그 표면이 움직이는 픽셀 수에는 한계가 있습니다.</translation>
    </message>
    <message>
        <source>Outline and details</source>
        <translation>윤곽과 세부</translation>
    </message>
    <message>
        <source>&amp;Outline and details</source>
        <translation>윤곽과 세부(&amp;O)</translation>
    </message>
    <message>
        <source>Show in the active view the boxes of the components that are always kept, and those of the others by what became of them</source>
        <translation>활성 뷰에 항상 유지되는 구성 요소의 상자를 표시하고, 나머지의 상자는 처리 결과에 따라 색을 달리하여 표시합니다</translation>
    </message>
    <message>
        <source>outline: always kept</source>
        <translation>윤곽: 항상 유지</translation>
    </message>
    <message>
        <source>The frame before took %1 of %2 ms: now the threshold is %3 and the outline %4 %.</source>
        <translation>앞 프레임은 %2 ms 가운데 %1 ms가 걸렸습니다. 이제 문턱값은 %3, 윤곽은 %4%입니다.</translation>
    </message>
    <message>
        <source>How many frames per second threshold and outline hold, by the frames&apos; own times; 0: they stay as they are set.</source>
        <translation>프레임 자체의 시간에 따라 문턱값과 윤곽이 유지하는 초당 프레임 수. 0: 정한 값 그대로 둡니다.</translation>
    </message>
    <message>
        <source>Of %1 triangles %2 hold no pixel centre.</source>
        <translation>삼각형 %1개 중 %2개에는 픽셀 중심이 없습니다.</translation>
    </message>
    <message>
        <source>leave out triangles without a centre</source>
        <translation>중심이 없는 삼각형은 제외</translation>
    </message>
    <message>
        <source>Whether triangles without a pixel centre are left out of components that are drawn. It loses nothing.</source>
        <translation>그리는 구성 요소에서 픽셀 중심이 없는 삼각형을 제외할지 여부입니다. 잃는 것은 없습니다.</translation>
    </message>
    <message>
        <source>by row, above %1 steps</source>
        <translation>단계가 %1개를 넘어 행별</translation>
    </message>
    <message>
        <source>At column %1 the surface in front ends. The first one of those that remain, at depth %2, comes to the front without a comparison.</source>
        <translation>%1열에서 맨 앞 면이 끝남. 남은 면 가운데 첫째 면이 깊이 %2로 비교 없이 맨 앞에 옵니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface begins where none is in front, at depth %2: it comes to the front without a comparison.</source>
        <translation>%1열에서 맨 앞 면이 없는 곳에 면이 깊이 %2로 시작함: 비교 없이 맨 앞에 옵니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: it is farther.</source>
        <translation>%1열에서 면이 시작함. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 더 멉니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface begins. Its depth %2 is compared with %3 of the one in front: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>%1열에서 면이 시작함. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 같으므로 장면에서 먼저 나오는 면이 맨 앞입니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: it is nearer.</source>
        <translation>%1열에서 맨 앞 면이 끝난 곳에 면이 남아 있음. 그 깊이 %2를 지금까지 고른 면의 깊이 %3과 비교함: 더 가깝습니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: it is farther.</source>
        <translation>%1열에서 맨 앞 면이 끝난 곳에 면이 남아 있음. 그 깊이 %2를 지금까지 고른 면의 깊이 %3과 비교함: 더 멉니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface remains where the one in front ended. Its depth %2 is compared with %3 of the one taken so far: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>%1열에서 맨 앞 면이 끝난 곳에 면이 남아 있음. 그 깊이 %2를 지금까지 고른 면의 깊이 %3과 비교함: 같으므로 장면에서 먼저 나오는 면이 맨 앞입니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: it is nearer, and the span is split there.</source>
        <translation>%1열에서 한 면이 맨 앞 면과 교차할 수 있음. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 더 가까우므로 스팬을 거기서 나눕니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: it is farther.</source>
        <translation>%1열에서 한 면이 맨 앞 면과 교차할 수 있음. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 더 멉니다.</translation>
    </message>
    <message>
        <source>At column %1 a surface may cross the one in front. Its depth %2 is compared with %3 of that one: they are equal, and the one that comes first in the scene is in front.</source>
        <translation>%1열에서 한 면이 맨 앞 면과 교차할 수 있음. 그 깊이 %2를 맨 앞 면의 깊이 %3과 비교함: 같으므로 장면에서 먼저 나오는 면이 맨 앞입니다.</translation>
    </message>
    <message>
        <source>begins, none in front: in front</source>
        <translation>시작, 앞에 면 없음: 맨 앞</translation>
    </message>
    <message>
        <source>A coarser surface of the object is given to OpenGL in place of the triangle.</source>
        <translation>이 삼각형 대신 물체의 더 거친 표면이 OpenGL에 전달됩니다.</translation>
    </message>
    <message>
        <source>promise</source>
        <translation>보장</translation>
    </message>
    <message>
        <source>beyond snapping, px</source>
        <translation>맞춤을 넘는 것, 픽셀</translation>
    </message>
    <message>
        <source>worst view</source>
        <translation>가장 나쁜 시점</translation>
    </message>
    <message>
        <source>go on with the child drawn first</source>
        <translation>먼저 그릴 자식으로 갑니다</translation>
    </message>
    <message>
        <source>go on with the child drawn last</source>
        <translation>나중에 그릴 자식으로 갑니다</translation>
    </message>
    <message>
        <source>The system gives no thread for this: %1. Close other programs and try again.</source>
        <translation>시스템이 이 작업에 쓸 스레드를 만들지 못했습니다: %1. 다른 프로그램을 닫고 다시 시도하세요.</translation>
    </message>
    <message>
        <source>The system gives no thread for OpenGL. Close other programs, or allow this one more memory and threads (ulimit).</source>
        <translation>시스템이 OpenGL에 쓸 스레드를 만들지 못했습니다. 다른 프로그램을 닫거나 이 프로그램에 메모리와 스레드를 더 허용하세요(ulimit).</translation>
    </message>
    <message>
        <source>%1 is no session that can be read: it has more than %2 values.</source>
        <translation>%1은(는) 읽을 수 있는 세션이 아닙니다. 값이 %2개보다 많습니다.</translation>
    </message>
    <message>
        <source>What the strategy decided cannot be read: %1</source>
        <translation>전략이 내린 결정을 읽을 수 없습니다: %1</translation>
    </message>
    <message>
        <source>The views&apos; pictures would have %1 million pixels together, and at most %2 million are possible: choose smaller sizes.</source>
        <translation>뷰의 그림이 모두 합쳐 %1백만 픽셀이 되지만 최대 %2백만 픽셀까지 가능합니다. 더 작은 크기를 고르세요.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>메모리가 부족합니다.</translation>
    </message>
    <message>
        <source>The reason is not known.</source>
        <translation>이유는 알 수 없습니다.</translation>
    </message>
    <message>
        <source>This failed, and Cullscope goes on: %1 The session is kept in a file that the next start offers.</source>
        <translation>작업이 실패했지만 Cullscope는 계속 실행됩니다: %1 세션은 파일에 보존되며 다음에 시작할 때 열 수 있습니다.</translation>
    </message>
    <message>
        <source>This failed, and Cullscope goes on: %1 Save what you need.</source>
        <translation>작업이 실패했지만 Cullscope는 계속 실행됩니다: %1 필요한 것을 저장하세요.</translation>
    </message>
    <message>
        <source>Something failed when Cullscope last ran. The session was kept as it was then.</source>
        <translation>Cullscope를 지난번에 실행했을 때 오류가 있었습니다. 당시의 세션이 보존되어 있습니다.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: a progressive JPEG of %2x%3 pixels takes memory for all of them before the first is known. Save it without progressive coding.</source>
        <translation>%1 파일은 읽을 수 있는 그림이 아닙니다: %2x%3 픽셀의 프로그레시브 JPEG는 첫 픽셀을 알기 전에 모든 픽셀의 메모리가 필요합니다. 프로그레시브가 아닌 방식으로 저장하세요.</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: its name ends neither in .png, .jpg, .tif nor .exr.</source>
        <translation>%1 파일은 읽을 수 있는 그림이 아닙니다: 이름이 .png, .jpg, .tif, .exr 중 어느 것으로도 끝나지 않습니다.</translation>
    </message>
    <message>
        <source>%1 is no picture that can be read: its name says %2, and it does not begin as such a file does. Give it the ending of what it is.</source>
        <translation>%1 파일은 읽을 수 있는 그림이 아닙니다: 이름은 %2 형식이지만 내용이 그 형식으로 시작하지 않습니다. 실제 형식에 맞는 확장자를 붙이세요.</translation>
    </message>
    <message>
        <source>%1 has more than %2 poses. Divide the path into several files.</source>
        <translation>%1 파일에 자세가 %2개보다 많습니다. 경로를 여러 파일로 나누세요.</translation>
    </message>
    <message>
        <source>%1: a scene of this size needs about %2 MB of memory, more than the %3 MB allowed. Ask for fewer triangles or objects.</source>
        <translation>%1: 이 크기의 장면에는 허용된 %3 MB보다 많은 약 %2 MB의 메모리가 필요합니다. 삼각형이나 물체의 수를 줄이세요.</translation>
    </message>
    <message>
        <source>More than %1 generators stand one inside another. Write the inner scene to a mesh file with cullbench export, and name that file.</source>
        <translation>생성기가 %1개보다 많이 겹쳐 있습니다. 안쪽 장면을 cullbench export로 메시 파일에 저장하고 그 파일을 지정하세요.</translation>
    </message>
    <message>
        <source>the program that reads it has ended</source>
        <translation>읽는 프로그램이 끝났습니다</translation>
    </message>
    <message>
        <source>&quot;%1&quot; lacks a strategy before or behind a comma. Write A,B without more commas.</source>
        <translation>&quot;%1&quot;에서 쉼표 앞이나 뒤에 전략이 없습니다. 쉼표를 더 쓰지 말고 A,B로 쓰세요.</translation>
    </message>
    <message>
        <source>Triangles whose sides change by more than a tenth, because their object is too large beside them for floats: %1. Remove what lies far away, or make it an object of its own.</source>
        <translation>물체가 삼각형에 비해 너무 커서 float로 반올림할 때 변이 10분의 1 넘게 바뀌는 삼각형: %1. 멀리 있는 것을 제거하거나 별도의 물체로 만드세요.</translation>
    </message>
    <message>
        <source>OpenGL cannot be started, for want of memory. Close other programs, or allow this one more (ulimit -v).</source>
        <translation>메모리가 부족하여 OpenGL을 시작할 수 없습니다. 다른 프로그램을 닫거나 이 프로그램에 메모리를 더 허용하세요(ulimit -v).</translation>
    </message>
    <message>
        <source>Pictures cannot be written or read, for want of memory. Close other programs, or allow this one more (ulimit -v).</source>
        <translation>메모리가 부족하여 그림을 쓰거나 읽을 수 없습니다. 다른 프로그램을 닫거나 이 프로그램에 메모리를 더 허용하세요(ulimit -v).</translation>
    </message>
    <message>
        <source>OpenGL cannot be started, for want of threads. Close other programs, or allow this one more (ulimit -u).</source>
        <translation>스레드가 부족하여 OpenGL을 시작할 수 없습니다. 다른 프로그램을 닫거나 이 프로그램에 스레드를 더 허용하세요(ulimit -u).</translation>
    </message>
    <message>
        <source>First click the part, then the leaf in which it lies.</source>
        <translation>먼저 부분을 클릭한 다음 그것이 놓인 잎을 클릭하십시오.</translation>
    </message>
    <message>
        <source>%1 is no answer here: the list beside the question has all of them.</source>
        <translation>%1 - 여기서는 답이 될 수 없습니다. 질문 옆의 목록에 답이 모두 있습니다.</translation>
    </message>
    <message>
        <source>Nothing of %1 is drawn: it lies nowhere.</source>
        <translation>%1 - 그려지는 것이 없어 어디에도 놓이지 않습니다.</translation>
    </message>
    <message>
        <source>%1 has several parts: click one of them in a view.</source>
        <translation>%1 - 부분이 여러 개입니다. 뷰에서 그중 하나를 클릭하십시오.</translation>
    </message>
    <message>
        <source>Triangles of the scene are drawn: %1 (ranges: %2)</source>
        <translation>장면의 삼각형을 그림: %1개 (범위: %2개)</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1; hit: %2</source>
        <translation>OpenGL에 묻는 상자: %1개, 맞은 것: %2개</translation>
    </message>
    <message>
        <source>Triangle %2 is drawn, with node %3.</source>
        <translation>%2 삼각형을 노드 %3에서 그립니다.</translation>
    </message>
    <message>
        <source>The tree has the triangle as a whole, drawn where the walk comes to it.</source>
        <translation>트리에는 삼각형이 통째로 있고, 순회가 그곳에 이를 때 그려집니다.</translation>
    </message>
    <message>
        <source>Triangle %2 covers no sample and is compared with none: it is drawn.</source>
        <translation>%2 삼각형은 샘플을 덮지 않아 어떤 것과도 비교되지 않고 그려집니다.</translation>
    </message>
    <message>
        <source>The centroid of triangle %2, at the distance %3, is the farthest one left: it is drawn without a test.</source>
        <translation>거리 %3에 있는 삼각형 %2의 무게중심이 남은 것 가운데 가장 멉니다. 검사 없이 그립니다.</translation>
    </message>
    <message>
        <source>Because of rounding alone triangle %2 still waits for others, and none of them can be cut: it is drawn all the same.</source>
        <translation>반올림 때문에만 %2 삼각형이 아직 다른 것을 기다리고, 그중 자를 수 있는 것이 없습니다. 그래도 그립니다.</translation>
    </message>
    <message>
        <source>Nothing is left that has to come before: triangle %2 is drawn.</source>
        <translation>먼저 와야 할 것이 남아 있지 않습니다. %2 삼각형을 그립니다.</translation>
    </message>
    <message>
        <source>No surface reaches here: nothing is compared, and nothing is filled.</source>
        <translation>여기에 이르는 면이 없습니다. 비교하는 것도 채우는 것도 없습니다.</translation>
    </message>
    <message>
        <source>Up to this step it is drawn, as a whole or in part; pieces: %1.</source>
        <translation>이 단계까지 전체 또는 일부가 그려졌습니다. 조각: %1개.</translation>
    </message>
    <message>
        <source>Up to this step nothing of it is decided, and nothing of it is drawn.</source>
        <translation>이 단계까지 그것에 대해 결정된 것도 그려진 것도 없습니다.</translation>
    </message>
    <message>
        <source>Up to this step it is decided to be drawn, and nothing of it is drawn yet.</source>
        <translation>이 단계까지 그리기로 결정되었지만 아직 그려진 것은 없습니다.</translation>
    </message>
    <message>
        <source>Depths compared in this row: %1, by a depth buffer: %2; spans filled: %3.</source>
        <translation>이 행에서 비교한 깊이: %1개, 깊이 버퍼라면: %2개. 채운 스팬: %3개.</translation>
    </message>
    <message>
        <source>In row %1 there are active edges: %2; surfaces: %3.</source>
        <translation>%1행의 활성 변: %2개, 면: %3개.</translation>
    </message>
    <message>
        <source>In row %1 there are active edges: %2; surfaces: %3. They lie at x = %4.</source>
        <translation>%1행의 활성 변: %2개, 면: %3개. x = %4.</translation>
    </message>
    <message>
        <source>millimetres that triangles lie away from round surfaces at most; without it, 8 to 32 chords by size</source>
        <translation>삼각형이 둥근 면에서 떨어지는 최대 거리(밀리미터). 주지 않으면 크기에 따라 원마다 8~32개의 현</translation>
    </message>
    <message>
        <source>by-object</source>
        <translation>물체별</translation>
    </message>
    <message>
        <source>× same sides [95 %]</source>
        <translation>× 같은 면 [95 %]</translation>
    </message>
    <message>
        <source>× a baseline that draws the same sides</source>
        <translation>× 같은 면을 그리는 기준선</translation>
    </message>
    <message>
        <source>N poses in a scene that one stands in: above its floors, outside solids, where much is seen</source>
        <translation>안에 서 있게 되는 장면의 자세 N개: 바닥 위, 입체 밖, 많은 것이 보이는 곳</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is neither a camera path file nor a built-in path. Built in: %2.</source>
        <translation>&quot;%1&quot;은(는) 카메라 경로 파일도 내장 경로도 아닙니다. 내장 경로: %2.</translation>
    </message>
    <message>
        <source>draw all its triangles</source>
        <translation>그 삼각형을 모두 그립니다</translation>
    </message>
    <message>
        <source>front sides of each object whose mesh is closed, both sides of the others</source>
        <translation>메시가 닫힌 물체는 앞면, 나머지는 양면</translation>
    </message>
    <message>
        <source>baseline, same sides</source>
        <translation>기준선, 같은 면</translation>
    </message>
    <message>
        <source>There is no lesson &quot;%1&quot;: name a lesson&apos;s file, or one of %2.</source>
        <translation>&quot;%1&quot;(이)라는 수업이 없습니다. 수업 파일이나 다음 중 하나를 쓰십시오: %2.</translation>
    </message>
    <message>
        <source>%1 is no lesson that can be read: it has more than %2 bytes.</source>
        <translation>%1은(는) 읽을 수 있는 수업이 아닙니다. %2바이트보다 큽니다.</translation>
    </message>
    <message>
        <source>%1: a lesson needs a title and at least one line &quot;step&quot;.</source>
        <translation>%1: 수업에는 제목과 &quot;step&quot; 줄이 하나 이상 있어야 합니다.</translation>
    </message>
    <message>
        <source>%1: the line is no UTF-8: save the file as UTF-8.</source>
        <translation>%1: 이 줄은 UTF-8이 아닙니다. 파일을 UTF-8로 저장하십시오.</translation>
    </message>
    <message>
        <source>%1: a lesson has at most %2 steps.</source>
        <translation>%1: 수업의 단계는 %2개까지입니다.</translation>
    </message>
    <message>
        <source>%1: &quot;%2&quot; is no language: write one of %3 before the sentence.</source>
        <translation>%1: &quot;%2&quot;은(는) 언어가 아닙니다. 문장 앞에 %3 중 하나를 쓰십시오.</translation>
    </message>
    <message>
        <source>%1: the sentence is missing.</source>
        <translation>%1: 문장이 없습니다.</translation>
    </message>
    <message>
        <source>%1: there is a sentence in &quot;%2&quot; already.</source>
        <translation>%1: &quot;%2&quot; 문장이 이미 있습니다.</translation>
    </message>
    <message>
        <source>%1: the value has too many brackets.</source>
        <translation>%1: 값에 괄호가 너무 많습니다.</translation>
    </message>
    <message>
        <source>%1: write a field of a session and its value, such as &quot;A.role observer&quot;.</source>
        <translation>%1: &quot;A.role observer&quot;처럼 세션의 필드와 값을 쓰십시오.</translation>
    </message>
    <message>
        <source>%1: write &quot;home&quot;, six numbers (where the camera stands and where it looks), or a camera path and the number of a pose from 0, such as &quot;case-1 3&quot;.</source>
        <translation>%1: &quot;home&quot;, 수 여섯 개(카메라가 선 곳과 보는 곳), 또는 &quot;case-1 3&quot;처럼 카메라 경로와 0부터 센 자세 번호를 쓰십시오.</translation>
    </message>
    <message>
        <source>%1: a session has no field &quot;%2&quot; here.</source>
        <translation>%1: 세션에는 여기에 &quot;%2&quot; 필드가 없습니다.</translation>
    </message>
    <message>
        <source>%1: the step has no sentence: add a line &quot;say&quot;.</source>
        <translation>%1: 단계에 문장이 없습니다. &quot;say&quot; 줄을 넣으십시오.</translation>
    </message>
    <message>
        <source>The camera path %1 has no pose %2 here: its last one is %3.</source>
        <translation>카메라 경로 %1에는 %2번 자세가 없습니다. 마지막은 %3입니다.</translation>
    </message>
    <message>
        <source>there are 1, 2, 4, 6 or 8 views.</source>
        <translation>뷰는 1, 2, 4, 6 또는 8개입니다.</translation>
    </message>
    <message>
        <source>The step was added to the lesson %1.</source>
        <translation>단계를 수업 %1에 추가했습니다.</translation>
    </message>
    <message>
        <source>%1: name a handout&apos;s file that ends in .pdf or .html.</source>
        <translation>%1: 유인물 파일 이름은 .pdf나 .html로 끝나야 합니다.</translation>
    </message>
    <message>
        <source>What the paper leaves open, reading by reading</source>
        <translation>논문이 열어 둔 것, 읽는 방식별</translation>
    </message>
    <message>
        <source>Section 2.3 sends objects that no corner ray meets to the contour bands; Appendix 1 only those whose bounding sphere lies inside the frustum. What becomes of one to three rays that miss, how hits are joined, and whether a band that is hidden ends its sector, the paper does not say.</source>
        <translation>2.3절은 모서리 광선이 하나도 만나지 않는 물체를 등고선 띠로 보내고, 부록 1은 경계 구가 절두체 안에 있는 물체만 보냅니다. 빗나간 광선이 한 개에서 세 개일 때, 교점을 잇는 방법, 가려진 띠가 그 부채꼴을 끝내는지는 논문에 없습니다.</translation>
    </message>
    <message>
        <source>Where the spherical method works</source>
        <translation>구 좌표 방법이 통하는 곳</translation>
    </message>
    <message>
        <source>Eight directions spread evenly; the distance of the eye is in radii of the bounding sphere, the field of view is vertical, the picture 640 × 480. Of four corner rays that hit, the region between them is drawn; of none, contour bands decide.</source>
        <translation>고르게 퍼진 여덟 방향입니다. 눈의 거리는 경계 구 반지름의 배수, 시야각은 세로, 그림은 640 × 480입니다. 모서리 광선 넷이 맞으면 그 사이의 영역을 그리고, 하나도 맞지 않으면 등고선 띠가 정합니다.</translation>
    </message>
    <message>
        <source>distance, radii</source>
        <translation>거리, 반지름 배수</translation>
    </message>
    <message>
        <source>field of view, °</source>
        <translation>시야각, °</translation>
    </message>
    <message>
        <source>share of the faces</source>
        <translation>면의 비율</translation>
    </message>
    <message>
        <source>rays that hit, of 4</source>
        <translation>맞은 광선, 4개 중</translation>
    </message>
    <message>
        <source>The paper&apos;s column is the faces considered. Views are chosen so that spherical considers as many here, in the stated case; faces in the frustum, those on the far side too, and the rays that hit are results. Where a lens has no such view, the nearest one is measured, and its row shows it.</source>
        <translation>논문의 열은 고려되는 면 개수입니다. 여기서 spherical이 해당 경우에서 그만큼을 고려하도록 시점을 골랐습니다. 뒤쪽 면까지 포함한 절두체 안의 면과 맞은 광선은 결과입니다. 그런 시점이 없는 렌즈는 가장 가까운 것을 재며, 그 행에 나타납니다.</translation>
    </message>
    <message>
        <source>The built-in paths case-1 to case-3 have the paper&apos;s number of faces in the frustum instead.</source>
        <translation>내장 경로 case-1에서 case-3까지는 그 대신 절두체 안의 면이 논문의 개수입니다.</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>예</translation>
    </message>
    <message>
        <source>no</source>
        <translation>아니요</translation>
    </message>
    <message>
        <source>Which cases have views that consider the paper&apos;s faces</source>
        <translation>논문의 면 개수를 고려하는 시점이 있는 경우</translation>
    </message>
    <message>
        <source>faces wanted</source>
        <translation>원하는 면</translation>
    </message>
    <message>
        <source>share wanted</source>
        <translation>원하는 비율</translation>
    </message>
    <message>
        <source>least share</source>
        <translation>최소 비율</translation>
    </message>
    <message>
        <source>most share</source>
        <translation>최대 비율</translation>
    </message>
    <message>
        <source>exists</source>
        <translation>있음</translation>
    </message>
    <message>
        <source>else bands: S &gt; S before it?</source>
        <translation>아니면 띠: S &gt; 앞의 S?</translation>
    </message>
    <message>
        <source>Which objects contour bands decide about.</source>
        <translation>등고선 띠가 정하는 물체.</translation>
    </message>
    <message>
        <source>those in the frustum that no corner ray meets (section 2.3)</source>
        <translation>절두체 안에 있고 모서리 광선이 만나지 않는 물체 (2.3절)</translation>
    </message>
    <message>
        <source>those whose sphere lies inside the frustum (Appendix 1)</source>
        <translation>경계 구가 절두체 안에 있는 물체 (부록 1)</translation>
    </message>
    <message>
        <source>What becomes of a corner ray that meets no triangle.</source>
        <translation>삼각형을 만나지 않은 모서리 광선의 처리.</translation>
    </message>
    <message>
        <source>the point of the sphere or box nearest to it is a corner of the region</source>
        <translation>광선에 가장 가까운 구나 상자의 점이 영역의 모서리가 됩니다</translation>
    </message>
    <message>
        <source>the region has no corner there</source>
        <translation>그곳에는 영역의 모서리가 없습니다</translation>
    </message>
    <message>
        <source>contour bands decide about the object</source>
        <translation>등고선 띠가 그 물체를 정합니다</translation>
    </message>
    <message>
        <source>Where corner rays begin, and where a missed one takes its point.</source>
        <translation>모서리 광선이 시작하는 곳, 빗나간 광선이 점을 얻는 곳.</translation>
    </message>
    <message>
        <source>the bounding sphere (sections 2.2 and 2.3)</source>
        <translation>경계 구 (2.2절과 2.3절)</translation>
    </message>
    <message>
        <source>the bounding box (Appendix 1)</source>
        <translation>경계 상자 (부록 1)</translation>
    </message>
    <message>
        <source>How the hits are joined to the visible region.</source>
        <translation>교점을 가시 영역으로 잇는 방법.</translation>
    </message>
    <message>
        <source>When a pole lies in the visible region, which is case 1.</source>
        <translation>극이 가시 영역에 드는 조건, 즉 경우 1.</translation>
    </message>
    <message>
        <source>when the surface in its direction is within the view</source>
        <translation>그 방향의 표면이 시야 안에 있을 때</translation>
    </message>
    <message>
        <source>when the outline winds around it</source>
        <translation>윤곽이 그 둘레를 감을 때</translation>
    </message>
    <message>
        <source>What a band hides whose S does not exceed the largest before it.</source>
        <translation>S가 앞의 최댓값을 넘지 않는 띠가 가리는 것.</translation>
    </message>
    <message>
        <source>itself and all bands of its sector behind it</source>
        <translation>자신과 그 부채꼴에서 뒤에 있는 모든 띠</translation>
    </message>
    <message>
        <source>itself alone</source>
        <translation>자신만</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: S %1 ≤ %2, the largest before it: hidden. The sector&apos;s band up to α = %5° was hidden before and ended it.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: S %1 ≤ 그 앞의 최댓값 %2. 가려집니다. 그 부채꼴의 α = %5°까지의 띠가 먼저 가려져 부채꼴을 끝냈습니다.</translation>
    </message>
    <message>
        <source>Sector %4, band up to α = %3°: its S %1 exceeds %2, the largest before it, but the sector&apos;s band up to α = %5° was hidden and ended it: nothing behind that one is drawn.</source>
        <translation>부채꼴 %4, α = %3°까지의 띠: S %1은 그 앞의 최댓값 %2보다 크지만, 그 부채꼴의 α = %5°까지의 띠가 가려져 부채꼴을 끝냈습니다. 그 뒤는 그리지 않습니다.</translation>
    </message>
    <message>
        <source>Corner ray %1 enters the bounding box at R = %2.</source>
        <translation>모서리 광선 %1이 R = %2에서 경계 상자에 들어갑니다.</translation>
    </message>
    <message>
        <source>Corner ray %1 passes %2 cells of the map and hits nothing; it begins at R = %3.</source>
        <translation>모서리 광선 %1이 맵의 셀 %2개를 지나고 아무것도 맞히지 않습니다. 시작은 R = %3입니다.</translation>
    </message>
    <message>
        <source>Corner ray %1 misses the bounds (cells passed: %2); their point nearest to it is at R = %3.</source>
        <translation>모서리 광선 %1이 경계를 빗나갑니다(지난 셀: %2). 가장 가까운 경계의 점은 R = %3에 있습니다.</translation>
    </message>
    <message>
        <source>Of the four corner rays %1 meet the object, which is not outside the frustum: contour bands decide about it.</source>
        <translation>모서리 광선 넷 중 %1개가 물체를 만나고, 물체는 절두체 밖에 있지 않습니다. 등고선 띠가 정합니다.</translation>
    </message>
    <message>
        <source>The region between the corners is case %1; boxes around it: %2; triangles in their cells: %3.</source>
        <translation>모서리 사이의 영역은 경우 %1입니다. 둘러싼 상자: %2, 그 셀들의 삼각형: %3.</translation>
    </message>
    <message>
        <source>not at all: the bounding sphere by its radius</source>
        <translation>상자 없이: 경계 구를 반지름으로</translation>
    </message>
    <message>
        <source>Where the six planes come from.</source>
        <translation>여섯 평면을 얻는 곳.</translation>
    </message>
    <message>
        <source>the camera&apos;s basis</source>
        <translation>카메라의 기저</translation>
    </message>
    <message>
        <source>rows of the clip matrix (Gribb &amp; Hartmann 2001)</source>
        <translation>클립 행렬의 행 (Gribb &amp; Hartmann 2001)</translation>
    </message>
    <message>
        <source>corners of the inverse clip cube (Orangelie 2023, mended)</source>
        <translation>클립 정육면체의 역변환 모서리 (Orangelie 2023, 고친 것)</translation>
    </message>
    <message>
        <source>the same as printed, with radius or extent length: loses objects</source>
        <translation>같은 것을 쓰인 그대로, 반지름이나 한계벡터 길이로: 물체를 잃습니다</translation>
    </message>
    <message>
        <source>1 ÷ (1 − culled), mean of the views</source>
        <translation>1 ÷ (1 − 컬링), 시점 평균</translation>
    </message>
    <message>
        <source>1 ÷ (1 − culled), best view</source>
        <translation>1 ÷ (1 − 컬링), 가장 좋은 시점</translation>
    </message>
    <message>
        <source>400 bunnies from 40 viewpoints fitted to the paper&apos;s figures</source>
        <translation>논문의 수치에 맞춘 40개 시점에서 본 토끼 400마리</translation>
    </message>
    <message>
        <source>The paper&apos;s mean of 12 times, its best of 39.8 times and its 79 % need other viewpoints than a walk: here 9 of 40 see 2.5 % of the bunnies, the others 26 %, so that the means of the culled shares and of what no culling can exceed are the paper&apos;s. Its direct rendering takes the same time at every view; a software OpenGL&apos;s does not.</source>
        <translation>논문의 평균 12배, 최고 39.8배, 79 %에는 걷는 경로와 다른 시점이 필요합니다. 여기서는 40개 중 9개가 토끼의 2.5 %를, 나머지가 26 %를 보므로, 컬링 비율의 평균과 어떤 컬링도 넘을 수 없는 값의 평균이 논문과 같습니다. 논문의 직접 렌더링은 모든 시점에서 같은 시간이 걸리지만 소프트웨어 OpenGL은 그렇지 않습니다.</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>폴더 열기</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>앞</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>뒤</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>왼쪽</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>오른쪽</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>위</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>아래</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>등각</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>와이어프레임</translation>
    </message>
    <message>
        <source>W&amp;ireframe</source>
        <translation>와이어프레임(&amp;I)</translation>
    </message>
    <message>
        <source>Show the edges of the drawn triangles alone; figures stay those of the filled picture</source>
        <translation>그려진 삼각형의 변만 보이기. 수치는 채워진 그림의 것 그대로입니다</translation>
    </message>
    <message>
        <source>The exact picture shows %1 triangles. They are known beforehand, and in no time of the frame.</source>
        <translation>정확한 그림에 삼각형 %1개가 보입니다. 미리 알고 있으며 프레임의 시간에 들지 않습니다.</translation>
    </message>
    <message>
        <source>Oracle</source>
        <translation>오라클</translation>
    </message>
    <message>
        <source>Draws exactly what is visible, known beforehand: what any culling could gain at most.</source>
        <translation>미리 알고 보이는 것만 그립니다. 어떤 컬링이든 얻을 수 있는 최대입니다.</translation>
    </message>
    <message>
        <source>What is drawn where any of it is visible.</source>
        <translation>일부라도 보이는 것에서 그리는 단위.</translation>
    </message>
    <message>
        <source>the visible triangles</source>
        <translation>보이는 삼각형</translation>
    </message>
    <message>
        <source>whole objects of which anything is visible</source>
        <translation>일부라도 보이는 물체 전체</translation>
    </message>
    <message>
        <source>know what is visible (not timed)</source>
        <translation>보이는 것을 앎 (재지 않음)</translation>
    </message>
    <message>
        <source>draw what is visible of it</source>
        <translation>그중 보이는 것을 그림</translation>
    </message>
    <message>
        <source>nothing: leave it out</source>
        <translation>없으면 뺌</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>그림 %1</translation>
    </message>
    <message>
        <source>--pose %1: the path %2 has %3 poses, counted from 0.</source>
        <translation>--pose %1: 경로 %2에는 자세가 %3개 있으며 0부터 셉니다.</translation>
    </message>
    <message>
        <source>Figure %1: this frame decided nothing that could be shown.</source>
        <translation>그림 %1: 이 프레임에는 보여 줄 판정이 없습니다.</translation>
    </message>
    <message>
        <source>There is no Figure %1: the paper has 1 to %2.</source>
        <translation>그림 %1은 없습니다. 논문에는 1부터 %2까지 있습니다.</translation>
    </message>
    <message>
        <source>--step %1: this frame has the steps 0 to %2.</source>
        <translation>--step %1: 이 프레임의 단계는 0부터 %2까지입니다.</translation>
    </message>
    <message>
        <source>the step in hand: %1 of %2</source>
        <translation>지금 단계: %2 중 %1</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>제출됨</translation>
    </message>
    <message>
        <source>rest of the object</source>
        <translation>물체의 나머지</translation>
    </message>
    <message>
        <source>bounding sphere</source>
        <translation>경계구</translation>
    </message>
    <message>
        <source>where it enters the sphere</source>
        <translation>구로 들어가는 곳</translation>
    </message>
    <message>
        <source>S of a band that is hidden</source>
        <translation>가려진 띠의 S</translation>
    </message>
    <message>
        <source>what is not drawn</source>
        <translation>그리지 않는 부분</translation>
    </message>
    <message>
        <source>front sides of what is drawn</source>
        <translation>그린 면의 앞면</translation>
    </message>
    <message>
        <source>Flow chart of the method</source>
        <translation>방법의 흐름도</translation>
    </message>
    <message>
        <source>The object and the same in spherical coordinates</source>
        <translation>물체와 구 좌표계에서의 표현</translation>
    </message>
    <message>
        <source>How the intersections of rays are computed</source>
        <translation>광선의 교차점 계산 과정</translation>
    </message>
    <message>
        <source>The visible region on the index map, by case</source>
        <translation>색인 맵에서 경우별 가시 영역</translation>
    </message>
    <message>
        <source>Sampled bands on the object, and their contours on the map</source>
        <translation>물체의 샘플링 띠와 맵 위의 등고선</translation>
    </message>
    <message>
        <source>S in the sampled bands</source>
        <translation>샘플링 띠에서의 S</translation>
    </message>
    <message>
        <source>Sampled bands and what they hide</source>
        <translation>샘플링 띠와 은면 제거</translation>
    </message>
    <message>
        <source>The picture without what is hidden, from both sides</source>
        <translation>은면이 제거된 영상, 앞과 뒤</translation>
    </message>
    <message>
        <source>There is no font for the picture&apos;s letters: install the package fonts-noto-cjk or fonts-dejavu-core, or write an .svg file, whose letters its viewer draws.</source>
        <translation>그림의 글자를 위한 글꼴이 없습니다. 패키지 fonts-noto-cjk 또는 fonts-dejavu-core를 설치하거나, 보는 프로그램이 글자를 그리는 .svg 파일로 쓰십시오.</translation>
    </message>
    <message>
        <source>Ghost of the whole objects</source>
        <translation>물체 전체의 잔상</translation>
    </message>
    <message>
        <source>&amp;Ghost of the whole objects</source>
        <translation>물체 전체의 잔상(&amp;G)</translation>
    </message>
    <message>
        <source>Show all objects as ghosts around what was drawn of them in the active view</source>
        <translation>활성 뷰에서 그려진 부분 둘레에 모든 물체를 잔상으로 보여 줍니다</translation>
    </message>
    <message>
        <source>Back sides in orange</source>
        <translation>뒷면을 주황색으로</translation>
    </message>
    <message>
        <source>Back si&amp;des in orange</source>
        <translation>뒷면을 주황색으로(&amp;D)</translation>
    </message>
    <message>
        <source>Show the back sides of surfaces in orange in the active view: what is hollow is not taken for a body</source>
        <translation>활성 뷰에서 표면의 뒷면을 주황색으로 보여 줍니다. 속이 빈 것을 물체로 잘못 보지 않게 됩니다</translation>
    </message>
    <message>
        <source>Vertices to spherical coordinates R, θ, φ</source>
        <translation>정점을 구 좌표 R, θ, φ로</translation>
    </message>
    <message>
        <source>Centroid map, triangle index map, memory access map</source>
        <translation>무게중심 맵, 삼각형 색인 맵, 메모리 접근 맵</translation>
    </message>
    <message>
        <source>Bounding sphere and frustum</source>
        <translation>경계구와 절두체</translation>
    </message>
    <message>
        <source>Nothing is drawn</source>
        <translation>아무것도 그리지 않음</translation>
    </message>
    <message>
        <source>Inside the frustum?</source>
        <translation>절두체 안에 있는가?</translation>
    </message>
    <message>
        <source>Search of the triangle index map for the triangles hit</source>
        <translation>삼각형 색인 맵에서 교차한 삼각형 탐색</translation>
    </message>
    <message>
        <source>Does a ray meet the object?</source>
        <translation>물체와 만나는 광선이 있는가?</translation>
    </message>
    <message>
        <source>Visible region on the map: case 1, 2 or 3</source>
        <translation>맵 위의 가시 영역: 경우 1, 2, 3</translation>
    </message>
    <message>
        <source>Boxes around it, ranges of the memory access map</source>
        <translation>경계 상자, 메모리 접근 맵의 구간</translation>
    </message>
    <message>
        <source>Graphics pipeline</source>
        <translation>그래픽스 파이프라인</translation>
    </message>
    <message>
        <source>%1 was written by another version: its blocks are not those of this one.</source>
        <translation>%1 파일은 다른 버전이 쓴 것입니다. 블록이 이 버전의 것과 다릅니다.</translation>
    </message>
    <message>
        <source>%1 is no state of cullbench certify that can be read. Name another file, or remove it and begin anew.</source>
        <translation>%1은(는) 읽을 수 있는 cullbench certify 상태 파일이 아닙니다. 다른 파일을 지정하거나, 지우고 새로 시작하십시오.</translation>
    </message>
    <message>
        <source>There is nothing to merge: name state files.</source>
        <translation>합칠 것이 없습니다. 상태 파일을 지정하세요.</translation>
    </message>
    <message>
        <source>The state files are of different runs: %1 with seed %2 and %3 blocks, and %4 with seed %5 and %6 blocks.</source>
        <translation>상태 파일이 서로 다른 실행의 것입니다. 하나는 %1, 시드 %2, 블록 %3개이고 다른 하나는 %4, 시드 %5, 블록 %6개입니다.</translation>
    </message>
    <message>
        <source>Two of the state files tried block %1: each shard is to be merged once.</source>
        <translation>상태 파일 두 개가 %1번 블록을 시험했습니다. 각 조각은 한 번만 합치세요.</translation>
    </message>
    <message>
        <source>%1 has the state of another run, of %2 with seed %3: name another file, or remove it.</source>
        <translation>%1 파일에는 다른 실행(%2, 시드 %3)의 상태가 있습니다. 다른 파일을 지정하거나 이 파일을 지우세요.</translation>
    </message>
    <message>
        <source>certifying</source>
        <translation>검증 중</translation>
    </message>
    <message>
        <source>strategies that promise to lose nothing lose nothing</source>
        <translation>아무것도 잃지 않겠다고 약속한 전략은 아무것도 잃지 않음</translation>
    </message>
    <message>
        <source>ends, or stops with a sentence; areas are kept and nothing is lost</source>
        <translation>끝나거나 설명하며 멈춤. 넓이가 보존되고 잃는 것이 없음</translation>
    </message>
    <message>
        <source>A sphere beside a corner of the view that passes every plane test</source>
        <translation>시야 모서리 옆에서 모든 평면 검사를 통과하는 구</translation>
    </message>
    <message>
        <source>planes do not tell it apart, the exact test does</source>
        <translation>평면으로는 구별되지 않고 정확한 검사로는 구별됨</translation>
    </message>
    <message>
        <source>A box beside the view that passes every p-vertex test</source>
        <translation>시야 옆에서 모든 p-정점 검사를 통과하는 상자</translation>
    </message>
    <message>
        <source>A flat box above a plane</source>
        <translation>평면 위의 납작한 상자</translation>
    </message>
    <message>
        <source>its extent&apos;s length keeps it, its p-vertex does not</source>
        <translation>크기의 길이로는 남고 p-정점으로는 제거됨</translation>
    </message>
    <message>
        <source>A sphere at a plane ten million from the origin</source>
        <translation>원점에서 천만 떨어진 평면에 있는 구</translation>
    </message>
    <message>
        <source>visible; floats say that it is not</source>
        <translation>보임. 단정밀도로는 보이지 않는다고 나옴</translation>
    </message>
    <message>
        <source>A file with NaN, infinite numbers, faces without area and corners that are not there</source>
        <translation>NaN, 무한대, 넓이 없는 면, 없는 꼭짓점이 있는 파일</translation>
    </message>
    <message>
        <source>counted and left out; the other faces stay</source>
        <translation>세어서 빼고 다른 면은 남음</translation>
    </message>
    <message>
        <source>A triangle over the seam of a map of directions</source>
        <translation>방향 맵의 이음선에 걸친 삼각형</translation>
    </message>
    <message>
        <source>columns 359 and 0 only</source>
        <translation>359열과 0열만</translation>
    </message>
    <message>
        <source>A triangle around the pole of a map of directions</source>
        <translation>방향 맵의 극을 둘러싼 삼각형</translation>
    </message>
    <message>
        <source>every column of the polar row</source>
        <translation>극 행의 모든 열</translation>
    </message>
    <message>
        <source>Azimuths in other quadrants than the first</source>
        <translation>첫째 사분면이 아닌 곳의 방위각</translation>
    </message>
    <message>
        <source>225 and 90 degrees</source>
        <translation>225도와 90도</translation>
    </message>
    <message>
        <source>An azimuth that rounds to a whole turn</source>
        <translation>한 바퀴로 반올림되는 방위각</translation>
    </message>
    <message>
        <source>column 359 or 0, never 360</source>
        <translation>359열이나 0열이고 360열은 아님</translation>
    </message>
    <message>
        <source>A zenith angle of a hundred-millionth of a degree</source>
        <translation>1억분의 1도 규모의 천정각</translation>
    </message>
    <message>
        <source>kept; an arc cosine gives 0</source>
        <translation>유지됨. 아크코사인은 0을 줌</translation>
    </message>
    <message>
        <source>A corner or a centroid exactly at the centre</source>
        <translation>정확히 중심에 있는 꼭짓점이나 무게중심</translation>
    </message>
    <message>
        <source>finite, and a candidate in every direction</source>
        <translation>유한하고 모든 방향에서 후보임</translation>
    </message>
    <message>
        <source>A camera at three radii at every latitude</source>
        <translation>여러 위도에서 반지름 세 배 거리에 있는 카메라</translation>
    </message>
    <message>
        <source>A camera on the polar axis</source>
        <translation>극축 위의 카메라</translation>
    </message>
    <message>
        <source>A sphere in view that all four corner rays miss</source>
        <translation>네 모서리 광선이 모두 빗나가는 시야 안의 구</translation>
    </message>
    <message>
        <source>A ray that enters the bounding sphere far from where it hits</source>
        <translation>맞는 곳에서 먼 곳으로 경계구에 들어가는 광선</translation>
    </message>
    <message>
        <source>the walk reaches the surface, 37 degrees away</source>
        <translation>37도 떨어진 표면까지 탐색이 닿음</translation>
    </message>
    <message>
        <source>A tilted torus from afar</source>
        <translation>멀리서 본 기울어진 원환체</translation>
    </message>
    <message>
        <source>A thick bowl seen into its opening</source>
        <translation>입구 쪽에서 들여다본 두꺼운 그릇</translation>
    </message>
    <message>
        <source>A camera inside the bounding sphere, and exactly at its centre</source>
        <translation>경계구 안과 정확히 그 중심에 있는 카메라</translation>
    </message>
    <message>
        <source>Two surfaces a hundredth apart, near 0.01 and far a million</source>
        <translation>0.01 떨어진 두 면, 근평면 0.01과 원평면 백만</translation>
    </message>
    <message>
        <source>The same on a depth buffer of 24 bits, in both drawing orders</source>
        <translation>같은 것을 24비트 깊이 버퍼에 두 가지 그리는 순서로</translation>
    </message>
    <message>
        <source>wrong in one of them: floats are right in both</source>
        <translation>그중 하나에서 틀림. 부동소수는 둘 다 맞음</translation>
    </message>
    <message>
        <source>A body of size 1e-18</source>
        <translation>크기 1e-18의 물체</translation>
    </message>
    <message>
        <source>A body of size 1e18</source>
        <translation>크기 1e18의 물체</translation>
    </message>
    <message>
        <source>Bodies of both sizes in one scene</source>
        <translation>한 장면에 있는 두 크기의 물체</translation>
    </message>
    <message>
        <source>A scene moved by ten million, through its transforms and through its coordinates</source>
        <translation>변환과 좌표로 각각 천만만큼 옮긴 장면</translation>
    </message>
    <message>
        <source>the same objects, the same picture away from edges, and nothing lost</source>
        <translation>같은 물체, 모서리 밖에서 같은 그림, 잃는 것 없음</translation>
    </message>
    <message>
        <source>A box around the eye, and one that reaches beyond the far plane</source>
        <translation>눈을 둘러싼 상자와 원평면 너머까지 닿는 상자</translation>
    </message>
    <message>
        <source>not outside, and nothing lost</source>
        <translation>밖이 아니고 잃는 것 없음</translation>
    </message>
    <message>
        <source>A field of view of a hundredth of a degree</source>
        <translation>100분의 1도의 시야각</translation>
    </message>
    <message>
        <source>A field of view of 179 degrees</source>
        <translation>179도의 시야각</translation>
    </message>
    <message>
        <source>An eye that turns by 180 degrees a second, and answers that come late</source>
        <translation>초당 180도로 도는 눈과 늦게 오는 답</translation>
    </message>
    <message>
        <source>without latency nothing is lost; with it the loss is seen</source>
        <translation>지연이 없으면 잃는 것이 없고 있으면 손실이 보임</translation>
    </message>
    <message>
        <source>Selection mode with 400 names in a buffer that is four words too small</source>
        <translation>네 워드 모자란 버퍼에 이름 400개를 넣는 선택 모드</translation>
    </message>
    <message>
        <source>the overflow is seen, and tried again: 400 hits</source>
        <translation>넘침을 알아채고 다시 시도함: 400개 적중</translation>
    </message>
    <message>
        <source>An object&apos;s box around the eye and the far plane, and an eye just outside of it</source>
        <translation>눈과 원평면을 둘러싼 물체 상자와 바로 그 밖의 눈</translation>
    </message>
    <message>
        <source>Three bars that overlap each other in a cycle</source>
        <translation>서로 순환하며 겹치는 막대 셋</translation>
    </message>
    <message>
        <source>cut at least once and right at every overlap; centroids alone are not</source>
        <translation>적어도 한 번 잘리고 겹친 곳마다 맞음. 무게중심만으로는 틀림</translation>
    </message>
    <message>
        <source>Edges through pixel centres: a triangle and its complement</source>
        <translation>픽셀 중심을 지나는 변: 삼각형과 그 여집합</translation>
    </message>
    <message>
        <source>10 and 6 pixels, 16 together, none twice</source>
        <translation>10과 6픽셀, 합쳐서 16이고 겹치지 않음</translation>
    </message>
    <message>
        <source>40,000 abutting parts just below the threshold of small features</source>
        <translation>작은 형상 임계값 바로 아래의 맞닿은 부품 40,000개</translation>
    </message>
    <message>
        <source>as published a hole opens; with a bound it does not</source>
        <translation>논문대로면 구멍이 나고 한계를 두면 나지 않음</translation>
    </message>
    <message>
        <source>Mirrored and flattened bodies</source>
        <translation>거울상 물체와 납작해진 물체</translation>
    </message>
    <message>
        <source>Ten thousand polygons in one plane in a BSP tree</source>
        <translation>한 평면에 있는 다각형 만 개의 BSP 트리</translation>
    </message>
    <message>
        <source>Polygons that share every edge in a BSP tree</source>
        <translation>모든 변을 공유하는 다각형의 BSP 트리</translation>
    </message>
    <message>
        <source>Slivers a billion times as long as wide in a BSP tree</source>
        <translation>길이가 폭의 10억 배인 조각의 BSP 트리</translation>
    </message>
    <message>
        <source>Ten thousand random triangles in a BSP tree</source>
        <translation>임의 삼각형 만 개의 BSP 트리</translation>
    </message>
    <message>
        <source>Two surfaces one rounding of a float apart</source>
        <translation>단정밀도 반올림 하나만큼 떨어진 두 면</translation>
    </message>
    <message>
        <source>unresolved, and not counted as missed</source>
        <translation>구별 불가이고 누락으로 세지 않음</translation>
    </message>
    <message>
        <source>Triangles through the near plane with every corner outside the view</source>
        <translation>모든 꼭짓점이 시야 밖이고 근평면을 지나는 삼각형</translation>
    </message>
    <message>
        <source>An empty object and triangles without area beside a square</source>
        <translation>정사각형 옆의 빈 물체와 넓이 없는 삼각형</translation>
    </message>
    <message>
        <source>There is no case &quot;%1&quot;. Known: their numbers, or %2.</source>
        <translation>&quot;%1&quot; 사례가 없습니다. 알려진 것: 번호 또는 %2.</translation>
    </message>
    <message>
        <source>all %1 findings are right</source>
        <translation>결과 %1개가 모두 맞음</translation>
    </message>
    <message>
        <source>cut by a plane: not told apart</source>
        <translation>평면에 걸침: 구별되지 않음</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>밖</translation>
    </message>
    <message>
        <source>inside, or cut by a plane</source>
        <translation>안, 또는 평면에 잘림</translation>
    </message>
    <message>
        <source>Show the contour bands of spherical strategies on the objects&apos; bounding spheres in the active view</source>
        <translation>활성 뷰에서 구 좌표 전략의 등고선 띠를 물체의 경계구 위에 보여 줍니다</translation>
    </message>
    <message>
        <source>S of the contour bands</source>
        <translation>등고선 띠의 S</translation>
    </message>
    <message>
        <source>S of the contour ba&amp;nds</source>
        <translation>등고선 띠의 S(&amp;N)</translation>
    </message>
    <message>
        <source>Show S of each contour band of one sector in the active view: a line from the axis to the surface that it is measured at, dashed where the band is hidden</source>
        <translation>활성 뷰에서 한 부채꼴의 각 등고선 띠의 S를 보여 줍니다. 축에서 그것을 잰 표면까지의 선이며, 띠가 가려진 곳은 점선입니다</translation>
    </message>
    <message>
        <source>write x, y, z or view, and a share, as in &quot;x:0.5&quot;.</source>
        <translation>x, y, z 또는 view와 비율을 쓰십시오. 예: &quot;x:0.5&quot;.</translation>
    </message>
    <message>
        <source>The height of a parallel view must be a number above 0, not %1.</source>
        <translation>평행 투영 뷰의 높이는 0보다 큰 수여야 하며, %1일 수 없습니다.</translation>
    </message>
    <message>
        <source>%1: &quot;projection&quot; must be &quot;perspective&quot; or &quot;parallel&quot;.</source>
        <translation>%1: &quot;projection&quot;은 &quot;perspective&quot; 또는 &quot;parallel&quot;이어야 합니다.</translation>
    </message>
    <message>
        <source>%1: a parallel projection needs its &quot;height&quot;, in scene units.</source>
        <translation>%1: 평행 투영에는 장면 단위의 &quot;height&quot;가 필요합니다.</translation>
    </message>
    <message>
        <source>%1 needs the place of an eye, and a parallel view has none: every triangle is drawn.</source>
        <translation>%1 전략에는 눈의 위치가 필요한데 평행 투영 뷰에는 눈이 없습니다. 모든 삼각형을 그립니다.</translation>
    </message>
    <message>
        <source>hit records, mean</source>
        <translation>적중 기록, 평균</translation>
    </message>
    <message>
        <source>overflows of the hit buffer</source>
        <translation>적중 버퍼 넘침</translation>
    </message>
    <message>
        <source>a vertex: position, normal; a face: 3 indices</source>
        <translation>정점: 위치, 법선; 면: 색인 3개</translation>
    </message>
    <message>
        <source>a face: 3 corners with position and normal</source>
        <translation>면: 위치와 법선이 있는 꼭짓점 3개</translation>
    </message>
    <message>
        <source>a face: 3 corners with position, 1 normal, 3 indices</source>
        <translation>면: 위치가 있는 꼭짓점 3개, 법선 1개, 색인 3개</translation>
    </message>
    <message>
        <source>the paper&apos;s formula: 4 floats a face</source>
        <translation>논문의 식: 면마다 float 4개</translation>
    </message>
    <message>
        <source>R, θ, φ in floats a face; 4 numbers a cell</source>
        <translation>면마다 float인 R, θ, φ; 셀마다 수 4개</translation>
    </message>
    <message>
        <source>R, θ, φ and index a face; 4 numbers a cell</source>
        <translation>면마다 R, θ, φ와 색인; 셀마다 수 4개</translation>
    </message>
    <message>
        <source>R, θ, φ in doubles a face; 4 numbers a cell</source>
        <translation>면마다 double인 R, θ, φ; 셀마다 수 4개</translation>
    </message>
    <message>
        <source>index and R an entry</source>
        <translation>항목마다 색인과 R</translation>
    </message>
    <message>
        <source>index and R an entry; start and count a cell</source>
        <translation>항목마다 색인과 R; 셀마다 시작과 개수</translation>
    </message>
    <message>
        <source>index, R and a link to the next an entry</source>
        <translation>항목마다 색인, R, 다음 항목의 연결</translation>
    </message>
    <message>
        <source>index an entry; start, nearest and farthest R a cell, as here</source>
        <translation>항목마다 색인; 셀마다 시작, 가장 가까운 R과 먼 R, 여기서와 같음</translation>
    </message>
    <message>
        <source>the paper&apos;s formula: 4 integers a cell</source>
        <translation>논문의 식: 셀마다 정수 4개</translation>
    </message>
    <message>
        <source>start and count a cell</source>
        <translation>셀마다 시작과 개수</translation>
    </message>
    <message>
        <source>What the sizes in Table 1 can be made of</source>
        <translation>표 1의 크기를 이루는 것</translation>
    </message>
    <message>
        <source>The paper gives about 10, 4.3, 6.7 and 0.51 MB, and formulas that give other sizes; 3.46 MB stands in its table without a word. Each row is a layout that fits its text, with its size here.</source>
        <translation>논문은 약 10, 4.3, 6.7, 0.51 MB라고 하며, 그 식들은 다른 크기를 냅니다. 3.46 MB는 설명 없이 표에 있습니다. 행마다 본문에 맞는 배치와 여기서의 크기가 있습니다.</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>배치</translation>
    </message>
    <message>
        <source>here: MiB</source>
        <translation>여기: MiB</translation>
    </message>
    <message>
        <source>off in MB, %</source>
        <translation>MB로 차이, %</translation>
    </message>
    <message>
        <source>off in MiB, %</source>
        <translation>MiB로 차이, %</translation>
    </message>
    <message>
        <source>bytes a face</source>
        <translation>면당 바이트</translation>
    </message>
    <message>
        <source>region between rays, share of the views</source>
        <translation>광선 사이의 영역, 시점의 비율</translation>
    </message>
    <message>
        <source>Views in which the region between rays is drawn, %</source>
        <translation>광선 사이의 영역을 그리는 시점, %</translation>
    </message>
    <message>
        <source>Corner rays that hit, of 4</source>
        <translation>교차하는 모서리 광선, 4개 중</translation>
    </message>
    <message>
        <source>Faces considered, %</source>
        <translation>고려되는 면, %</translation>
    </message>
    <message>
        <source>Lost pixels, %</source>
        <translation>잃은 픽셀, %</translation>
    </message>
    <message>
        <source>Speed, × all</source>
        <translation>속도, × all</translation>
    </message>
    <message>
        <source>one</source>
        <translation>하나</translation>
    </message>
    <message>
        <source>different</source>
        <translation>서로 다름</translation>
    </message>
    <message>
        <source>views of the windows</source>
        <translation>창의 시점</translation>
    </message>
    <message>
        <source>The paper does not say whether its windows show one view or different ones: both are measured. Different ones are spread evenly over a case&apos;s twelve views.</source>
        <translation>논문은 창들이 한 시점을 보이는지 서로 다른 시점을 보이는지 말하지 않습니다. 둘 다 측정합니다. 서로 다른 시점은 경우마다 열두 시점에 고르게 퍼져 있습니다.</translation>
    </message>
    <message>
        <source>Boxes are drawn in OpenGL&apos;s selection mode: %1; hit records: %2; the hit buffer of %3 words overflowed before: %4</source>
        <translation>OpenGL의 선택 모드로 그린 상자: %1, 적중 기록: %2, %3워드의 적중 버퍼가 그전에 넘친 횟수: %4</translation>
    </message>
    <message>
        <source>OpenGL was asked about the box, grown by %1: it was hit, at depths from %2 to %3.</source>
        <translation>%1만큼 키운 상자를 OpenGL에 물었고, 깊이 %2부터 %3까지에서 맞았습니다.</translation>
    </message>
    <message>
        <source>The mesh&apos;s axis to which the map&apos;s poles belong.</source>
        <translation>맵의 극이 놓이는 메시의 축.</translation>
    </message>
    <message>
        <source>z, as in equation (1)</source>
        <translation>z, 식 (1)과 같음</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y, which points up in many models</source>
        <translation>y, 많은 모델에서 위쪽</translation>
    </message>
    <message>
        <source>The point from which R and the directions are measured.</source>
        <translation>R과 방향을 재는 점.</translation>
    </message>
    <message>
        <source>the centre of the bounding sphere</source>
        <translation>경계구의 중심</translation>
    </message>
    <message>
        <source>the middle of the bounding box</source>
        <translation>경계 상자의 중앙</translation>
    </message>
    <message>
        <source>the centroid of the surface</source>
        <translation>표면의 무게중심</translation>
    </message>
    <message>
        <source>not outside</source>
        <translation>밖이 아님</translation>
    </message>
    <message>
        <source>separate</source>
        <translation>떨어져 있음</translation>
    </message>
    <message>
        <source>not separate</source>
        <translation>떨어져 있지 않음</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>비어 있음</translation>
    </message>
    <message>
        <source>no pixel lost where it promises so</source>
        <translation>약속한 곳에서 잃은 픽셀 없음</translation>
    </message>
    <message>
        <source>its loss is measured</source>
        <translation>손실을 잼</translation>
    </message>
    <message>
        <source>%1 of %2 pixels lost</source>
        <translation>%2픽셀 중 %1픽셀 손실</translation>
    </message>
    <message>
        <source>no pixel lost, or a sentence that says why it does not serve the scene</source>
        <translation>잃은 픽셀 없음, 또는 이 장면을 다루지 못하는 까닭을 말하는 문장</translation>
    </message>
    <message>
        <source>a loss that is seen</source>
        <translation>드러나는 손실</translation>
    </message>
    <message>
        <source>not tried</source>
        <translation>시도하지 않음</translation>
    </message>
    <message>
        <source>more than %1 % of the pixels lost, and that is seen</source>
        <translation>픽셀의 %1 % 넘게 잃고 그것이 드러남</translation>
    </message>
    <message>
        <source>a surface in the picture</source>
        <translation>그림 안의 표면</translation>
    </message>
    <message>
        <source>an empty picture</source>
        <translation>빈 그림</translation>
    </message>
    <message>
        <source>%1 pixels covered</source>
        <translation>덮인 픽셀 %1개</translation>
    </message>
    <message>
        <source>the nearer surface is seen</source>
        <translation>가까운 면이 보임</translation>
    </message>
    <message>
        <source>the farther surface is seen</source>
        <translation>먼 면이 보임</translation>
    </message>
    <message>
        <source>the picture of the scene at the origin</source>
        <translation>원점에 있는 장면의 그림</translation>
    </message>
    <message>
        <source>%1 pixels differ beyond the raster&apos;s snapping</source>
        <translation>래스터 맞춤으로 설명되지 않는 차이 %1픽셀</translation>
    </message>
    <message>
        <source>the objects of the scene at the origin</source>
        <translation>원점에 있는 장면의 물체</translation>
    </message>
    <message>
        <source>%1 views with other objects</source>
        <translation>물체가 다른 시점 %1개</translation>
    </message>
    <message>
        <source>400 hits</source>
        <translation>400개 적중</translation>
    </message>
    <message>
        <source>this OpenGL has no selection mode</source>
        <translation>이 OpenGL에는 선택 모드가 없음</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>%1보다 많음</translation>
    </message>
    <message>
        <source>areas kept to 1e-9</source>
        <translation>넓이가 1e-9까지 보존됨</translation>
    </message>
    <message>
        <source>%1 polygons, areas kept to %2</source>
        <translation>다각형 %1개, 넓이가 %2까지 보존됨</translation>
    </message>
    <message>
        <source>unresolved</source>
        <translation>구별 불가</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>누락</translation>
    </message>
    <message>
        <source>another difference</source>
        <translation>다른 차이</translation>
    </message>
    <message>
        <source>The drawn sets have %1 poses, and the camera path %2: give one set for each pose.</source>
        <translation>그린 집합에는 자세가 %1개, 카메라 경로에는 %2개 있습니다. 자세마다 집합을 하나씩 주세요.</translation>
    </message>
    <message>
        <source>judging</source>
        <translation>판정 중</translation>
    </message>
    <message>
        <source>No culling: nothing is left out, and %1 objects in view are drawn in vain.</source>
        <translation>컬링 없음: 빠진 것이 없고, 시야 안의 물체 %1개를 헛되이 그립니다.</translation>
    </message>
    <message>
        <source>View-frustum culling: all %1 objects that are left out lie outside the view, nothing that is seen is missing, and %2 objects in view are drawn though they are hidden.</source>
        <translation>절두체 컬링: 빠진 물체 %1개가 모두 시야 밖에 있고, 보이는 것은 빠지지 않았으며, 시야 안의 물체 %2개는 가려졌는데도 그립니다.</translation>
    </message>
    <message>
        <source>Occlusion culling: what is left out in view is not seen, and nothing that is seen is missing.</source>
        <translation>차폐 컬링: 시야 안에서 빠진 것은 보이지 않고, 보이는 것은 빠지지 않았습니다.</translation>
    </message>
    <message>
        <source>Something that is seen is missing: %1 times a visible object is not drawn whole.</source>
        <translation>보이는 것이 빠졌습니다. 보이는 물체가 온전히 그려지지 않은 경우가 %1번입니다.</translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation>%1 폴더를 만들 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>쓰는 중</translation>
    </message>
    <message>
        <source>the poses that the scene gives, as those of the gallery do; of others one that shows it all</source>
        <translation>갤러리처럼 장면이 주는 자세. 다른 장면은 전체를 보이는 자세 하나</translation>
    </message>
    <message>
        <source>%1: drawn sets need a list &quot;poses&quot; with at least one pose.</source>
        <translation>%1: 그린 집합에는 자세가 하나 이상인 &quot;poses&quot; 목록이 필요합니다.</translation>
    </message>
    <message>
        <source>%1: some poses have a camera and some have none. Give every pose one, or none.</source>
        <translation>%1: 카메라가 있는 자세와 없는 자세가 섞여 있습니다. 모든 자세에 주거나 모두 빼세요.</translation>
    </message>
    <message>
        <source>%1: pose %2 needs a list &quot;objects&quot; or a list &quot;triangles&quot; of what is drawn.</source>
        <translation>%1: 자세 %2에는 그린 것의 &quot;objects&quot; 목록이나 &quot;triangles&quot; 목록이 필요합니다.</translation>
    </message>
    <message>
        <source>%1: pose %2: %3 names nothing in this scene of %4 triangles in %5 objects. Numbers count from 0.</source>
        <translation>%1: 자세 %2: 물체 %5개, 삼각형 %4개인 이 장면에는 %3에 해당하는 것이 없습니다. 번호는 0부터 셉니다.</translation>
    </message>
    <message>
        <source>%1 is not JSON: it breaks off at byte %2. Drawn sets have a list &quot;poses&quot;.</source>
        <translation>%1 파일은 JSON이 아닙니다. %2바이트에서 끊깁니다. 그린 집합에는 &quot;poses&quot; 목록이 있습니다.</translation>
    </message>
    <message>
        <source>%1 holds a number that is too large.</source>
        <translation>%1 파일에 너무 큰 수가 있습니다.</translation>
    </message>
    <message>
        <source>a sphere beside a corner of the view that no single plane of it tells apart</source>
        <translation>어느 한 평면으로도 구별되지 않는, 시야 모서리 옆의 구</translation>
    </message>
    <message>
        <source>a box beside the view that no single plane of it tells apart</source>
        <translation>어느 한 평면으로도 구별되지 않는, 시야 옆의 상자</translation>
    </message>
    <message>
        <source>a corner and a centroid exactly at the centre of the bounding sphere</source>
        <translation>정확히 경계구 중심에 있는 꼭짓점과 무게중심</translation>
    </message>
    <message>
        <source>a sphere from three radii, at latitudes from the equator to the pole</source>
        <translation>적도에서 극까지의 위도에서 반지름 세 배 거리로 본 구</translation>
    </message>
    <message>
        <source>a sphere from above and below its poles</source>
        <translation>극의 위와 아래에서 본 구</translation>
    </message>
    <message>
        <source>a sphere half in view that all four corner rays miss</source>
        <translation>네 모서리 광선이 모두 빗나가는, 반쯤 보이는 구</translation>
    </message>
    <message>
        <source>a ball of half the radius of its bounding sphere: rays enter far from where they hit</source>
        <translation>경계구 반지름의 절반인 공: 광선이 맞는 곳에서 먼 곳으로 들어감</translation>
    </message>
    <message>
        <source>a torus tilted by 60 degrees, from afar</source>
        <translation>60도 기울어진 원환체, 멀리서 봄</translation>
    </message>
    <message>
        <source>a thick bowl seen into its opening</source>
        <translation>입구 쪽에서 들여다본 두꺼운 그릇</translation>
    </message>
    <message>
        <source>a star-shaped body from inside and from its very centre</source>
        <translation>안과 바로 그 중심에서 본 별꼴 물체</translation>
    </message>
    <message>
        <source>two squares a hundredth apart at distance 1000, near 0.01 and far a million</source>
        <translation>거리 1000에서 0.01 떨어진 두 정사각형, 근평면 0.01과 원평면 백만</translation>
    </message>
    <message>
        <source>a body of size 1e-18</source>
        <translation>크기 1e-18의 물체</translation>
    </message>
    <message>
        <source>a body of size 1e18</source>
        <translation>크기 1e18의 물체</translation>
    </message>
    <message>
        <source>bodies of sizes 1e-18 and 1e18 in one scene</source>
        <translation>한 장면에 있는 크기 1e-18과 1e18의 물체</translation>
    </message>
    <message>
        <source>four bodies at the origin, as those of case 21 that are moved</source>
        <translation>원점에 있는 물체 넷. 사례 21에서 옮겨지는 것과 같음</translation>
    </message>
    <message>
        <source>four bodies moved by ten million through their transforms</source>
        <translation>변환으로 천만만큼 옮긴 물체 넷</translation>
    </message>
    <message>
        <source>four bodies moved by ten million through their coordinates</source>
        <translation>좌표로 천만만큼 옮긴 물체 넷</translation>
    </message>
    <message>
        <source>a box around the eye, and one that reaches beyond the far plane on all sides</source>
        <translation>눈을 둘러싼 상자와 사방으로 원평면 너머까지 닿는 상자</translation>
    </message>
    <message>
        <source>a body in a field of view of a hundredth of a degree</source>
        <translation>100분의 1도 시야각 안의 물체</translation>
    </message>
    <message>
        <source>a body in a field of view of 179 degrees</source>
        <translation>179도 시야각 안의 물체</translation>
    </message>
    <message>
        <source>walls with bodies behind them, from an eye that turns by 180 degrees a second</source>
        <translation>초당 180도로 도는 눈에서 본, 뒤에 물체가 있는 벽들</translation>
    </message>
    <message>
        <source>an object whose box holds the eye and the far plane</source>
        <translation>상자 안에 눈과 원평면이 있는 물체</translation>
    </message>
    <message>
        <source>three bars that overlap each other in a cycle</source>
        <translation>서로 순환하며 겹치는 막대 셋</translation>
    </message>
    <message>
        <source>a triangle and its complement whose edges pass through pixel centres of an 8x8 picture</source>
        <translation>8x8 그림의 픽셀 중심을 변이 지나는 삼각형과 그 여집합</translation>
    </message>
    <message>
        <source>200 by 200 abutting parts just below the threshold of small features</source>
        <translation>작은 형상 임계값 바로 아래의 맞닿은 부품 200 × 200개</translation>
    </message>
    <message>
        <source>a mirrored body and a flattened one</source>
        <translation>거울상 물체와 납작해진 물체</translation>
    </message>
    <message>
        <source>ten thousand triangles in one plane</source>
        <translation>한 평면에 있는 삼각형 만 개</translation>
    </message>
    <message>
        <source>triangles that share their edges with many others</source>
        <translation>다른 많은 삼각형과 변을 공유하는 삼각형</translation>
    </message>
    <message>
        <source>slivers a billion times as long as wide, among random triangles</source>
        <translation>임의 삼각형 사이에 있는, 길이가 폭의 10억 배인 조각</translation>
    </message>
    <message>
        <source>ten thousand random triangles that fill a cube</source>
        <translation>정육면체를 채운 임의 삼각형 만 개</translation>
    </message>
    <message>
        <source>two squares one rounding of a float apart</source>
        <translation>단정밀도 반올림 하나만큼 떨어진 두 정사각형</translation>
    </message>
    <message>
        <source>triangles through the near plane with every corner outside the view</source>
        <translation>모든 꼭짓점이 시야 밖이고 근평면을 지나는 삼각형</translation>
    </message>
    <message>
        <source>an empty object and triangles without area beside a square</source>
        <translation>정사각형 옆의 빈 물체와 넓이 없는 삼각형</translation>
    </message>
    <message>
        <source>%1 has no cameras beside its sets, by which a view would find its own: give every pose eye, target and up.</source>
        <translation>%1 파일에는 시점이 자기 집합을 찾는 데 쓸 카메라가 없습니다. 모든 자세에 eye, target, up을 주세요.</translation>
    </message>
    <message>
        <source>The camera of pose %1 of the file is the nearest one: its set is drawn.</source>
        <translation>파일의 자세 %1의 카메라가 가장 가깝습니다. 그 집합을 그립니다.</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>기록</translation>
    </message>
    <message>
        <source>Draws what another program says that it draws at the nearest pose, from a file.</source>
        <translation>가장 가까운 자세에서 다른 프로그램이 그린다고 한 것을 파일에서 읽어 그립니다.</translation>
    </message>
    <message>
        <source>File of drawn sets with their cameras (JSON); without one everything is drawn.</source>
        <translation>카메라가 있는 그린 집합 파일(JSON). 없으면 모두 그립니다.</translation>
    </message>
    <message>
        <source>take the pose with the nearest camera</source>
        <translation>카메라가 가장 가까운 자세를 고름</translation>
    </message>
    <message>
        <source>draw what the file has of it</source>
        <translation>파일에 있는 그 물체의 부분을 그림</translation>
    </message>
    <message>
        <source>%1=%2: %1 is the name of a file.</source>
        <translation>%1=%2: %1은(는) 파일 이름입니다.</translation>
    </message>
    <message>
        <source>%1 of %2 findings are wrong, the first one: %3</source>
        <translation>결과 %2개 중 %1개가 틀림, 첫째: %3</translation>
    </message>
    <message>
        <source>all %1 findings are right; the control fails as it must: %2</source>
        <translation>결과 %1개가 모두 맞고 대조군은 마땅히 실패함: %2</translation>
    </message>
    <message>
        <source>The system gives no thread for this: close other programs.</source>
        <translation>시스템이 이 작업에 스레드를 주지 않습니다. 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>of the headroom, % [95 %]</source>
        <translation>여유 중 비율, % [95 %]</translation>
    </message>
    <message>
        <source>Left out, but drawn after all: less than one in %1 triangles of the object is left out, those that face away counted half, and drawing all of it in the order of neighbours is faster.</source>
        <translation>뺐지만 결국 그립니다. 물체의 삼각형 중 %1개에 1개도 되지 않게 빠지며(뒤로 향한 것은 절반으로 셈), 이웃 순서로 전체를 그리는 쪽이 빠릅니다.</translation>
    </message>
    <message>
        <source>No scene is open.</source>
        <translation>열린 장면이 없습니다.</translation>
    </message>
    <message>
        <source>The figure cannot be drawn: %1</source>
        <translation>그림을 그릴 수 없습니다: %1</translation>
    </message>
    <message>
        <source>the way taken until then</source>
        <translation>그때까지 지나온 길</translation>
    </message>
    <message>
        <source>Figure %1: no corner ray meets the object in this view. Choose another case or pose.</source>
        <translation>그림 %1: 이 시점에서는 어떤 모서리 광선도 물체와 만나지 않습니다. 다른 경우나 시점을 고르세요.</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>눈</translation>
    </message>
    <message>
        <source>visible region, on the surface</source>
        <translation>가시 영역, 표면 위</translation>
    </message>
    <message>
        <source>its box, on the surface</source>
        <translation>경계 상자, 표면 위</translation>
    </message>
    <message>
        <source>S of the bands of %1 in one sector</source>
        <translation>한 부채꼴에서 폭 %1인 띠의 S</translation>
    </message>
    <message>
        <source>hidden for good by a nearer band, though its S is larger</source>
        <translation>S가 더 크지만 더 가까운 띠 때문에 끝까지 가려짐</translation>
    </message>
    <message>
        <source>rim of what is drawn: there the shell ends</source>
        <translation>그려진 부분의 가장자리: 여기서 껍질이 끝남</translation>
    </message>
    <message>
        <source>It lost nothing in %1 views (&lt; 3/%1).</source>
        <translation>시점 %1개에서 아무것도 잃지 않았습니다(&lt; 3/%1).</translation>
    </message>
    <message>
        <source>It loses %1 of a million pixels, in %2 of %3 views.</source>
        <translation>백만 픽셀 중 %1개를, 시점 %3개 중 %2개에서 잃습니다.</translation>
    </message>
    <message>
        <source>It builds no structure.</source>
        <translation>자료구조를 만들지 않습니다.</translation>
    </message>
    <message>
        <source>Its structure takes %1 bytes and %2 ms to build, which no frame pays back.</source>
        <translation>자료구조는 %1바이트이고 구축에 %2 ms가 걸리며, 어떤 프레임도 이를 되갚지 못합니다.</translation>
    </message>
    <message>
        <source>Its structure takes %1 bytes and %2 ms to build, paid back after %3 frames.</source>
        <translation>자료구조는 %1바이트이고 구축에 %2 ms가 걸리며, 프레임 %3개 뒤에 되갚아집니다.</translation>
    </message>
    <message>
        <source>No culling could gain here for certain: drawing exactly what is visible is ×%1.</source>
        <translation>여기서는 어떤 컬링도 확실한 이득이 없습니다. 보이는 것만 그려도 ×%1입니다.</translation>
    </message>
    <message>
        <source>That is more than drawing exactly what is visible gains by OpenGL, which is ×%1.</source>
        <translation>이는 OpenGL로 보이는 것만 그릴 때의 이득인 ×%1보다 큽니다.</translation>
    </message>
    <message>
        <source>Any culling could gain ×%1 at most; this is %2 % of the time that could be saved.</source>
        <translation>컬링으로 얻을 수 있는 최대 이득은 ×%1이며, 이 전략은 절약할 수 있는 시간의 %2 %를 얻습니다.</translation>
    </message>
    <message>
        <source>Drawing everything is best here: nothing that may be used is faster.</source>
        <translation>여기서는 모두 그리는 것이 가장 좋습니다. 쓸 수 있는 것 중 더 빠른 것이 없습니다.</translation>
    </message>
    <message>
        <source>Drawing everything is best here, by %1: ×%2 the speed of drawing both sides.</source>
        <translation>여기서는 모두 그리는 것이 가장 좋습니다(%1). 양면을 그릴 때의 ×%2 속도입니다.</translation>
    </message>
    <message>
        <source>%1 is best here: ×%2 the speed of drawing everything.</source>
        <translation>여기서는 %1 전략이 가장 좋습니다. 모두 그릴 때의 ×%2 속도입니다.</translation>
    </message>
    <message>
        <source>the limit of culling</source>
        <translation>컬링의 한계</translation>
    </message>
    <message>
        <source>in the race to the end</source>
        <translation>끝까지 경주에 남음</translation>
    </message>
    <message>
        <source>slower: its interval excludes the best</source>
        <translation>더 느림: 구간이 최선을 제외함</translation>
    </message>
    <message>
        <source>far slower at the first views</source>
        <translation>처음 시점들에서 훨씬 느림</translation>
    </message>
    <message>
        <source>promises nothing in these views</source>
        <translation>이 시점들에서 아무것도 보장하지 않음</translation>
    </message>
    <message>
        <source>loses more than is allowed</source>
        <translation>허용된 것보다 많이 잃음</translation>
    </message>
    <message>
        <source>Nothing was measured that could be advised.</source>
        <translation>조언할 만큼 측정된 것이 없습니다.</translation>
    </message>
    <message>
        <source>trying strategies</source>
        <translation>전략을 시험하는 중</translation>
    </message>
    <message>
        <source>building its structure takes longer than %1 s</source>
        <translation>자료구조 구축이 %1초보다 오래 걸림</translation>
    </message>
    <message>
        <source>racing</source>
        <translation>경주하는 중</translation>
    </message>
    <message>
        <source>%1 names no measurement: say its number as in 3, or number and strategy as in 3:frustum.</source>
        <translation>%1에 해당하는 측정이 없습니다. 3처럼 번호로, 또는 3:frustum처럼 번호와 전략으로 지정하십시오.</translation>
    </message>
    <message>
        <source>Measurements %1 and %2 cannot be compared: their %3 differ.</source>
        <translation>측정 %1 및 %2의 비교 불가: %3 다름.</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>camera paths</source>
        <translation>카메라 경로</translation>
    </message>
    <message>
        <source>picture sizes</source>
        <translation>그림 크기</translation>
    </message>
    <message>
        <source>Measurement %1 has no run of %2. It has: %3.</source>
        <translation>측정 %1에는 %2의 결과가 없습니다. 있는 전략: %3.</translation>
    </message>
    <message>
        <source>Measurements %1 and %2 cannot be compared: they have no run or pose in common.</source>
        <translation>측정 %1 및 %2의 비교 불가: 공통된 전략이나 자세가 없습니다.</translation>
    </message>
    <message>
        <source>B has %1 times the speed of A; of single frames there is no interval</source>
        <translation>B의 속도는 A의 %1배이며, 프레임이 하나뿐이라 구간이 없습니다</translation>
    </message>
    <message>
        <source>B is faster: %1 times the speed of A</source>
        <translation>B가 더 빠름: A 속도의 %1배</translation>
    </message>
    <message>
        <source>B is slower: %1 times the speed of A</source>
        <translation>B가 더 느림: A 속도의 %1배</translation>
    </message>
    <message>
        <source>no difference that this measurement tells: B has %1 times the speed of A</source>
        <translation>이 측정으로는 차이를 알 수 없음: B의 속도는 A의 %1배</translation>
    </message>
    <message>
        <source>%1 is no result store, or is damaged. Name another file.</source>
        <translation>%1은(는) 결과 저장소가 아니거나 손상되었습니다. 다른 파일을 지정하십시오.</translation>
    </message>
    <message>
        <source>%1 is in use: another program has been writing to it for half a minute.</source>
        <translation>%1 파일이 사용 중입니다. 다른 프로그램이 30초째 쓰고 있습니다.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. What was stored before is there.</source>
        <translation>%1 파일에 쓸 수 없습니다: %2. 이미 저장된 것은 그대로 있습니다.</translation>
    </message>
    <message>
        <source>The result store %1 cannot be opened: %2.</source>
        <translation>결과 저장소 %1 파일을 열 수 없습니다: %2.</translation>
    </message>
    <message>
        <source>%1 was written by a newer version of Cullscope (layout %2, this one knows %3): use that one.</source>
        <translation>%1 파일은 더 새로운 버전의 Cullscope로 기록되었습니다(구조 %2, 이 버전은 %3까지). 그 버전을 사용하십시오.</translation>
    </message>
    <message>
        <source>%1 has no measurement %2: list them with cullbench store %1 list.</source>
        <translation>%1 파일에 측정 %2이(가) 없습니다. cullbench store %1 list로 목록을 보십시오.</translation>
    </message>
    <message>
        <source>Speed against a baseline that draws the same sides</source>
        <translation>같은 면을 그리는 기준선 대비 속도</translation>
    </message>
    <message>
        <source>Speed against drawing everything</source>
        <translation>모두 그리기 대비 속도</translation>
    </message>
    <message>
        <source>Speed against drawing all front faces</source>
        <translation>모든 앞면 그리기 대비 속도</translation>
    </message>
    <message>
        <source>fps in the slowest view</source>
        <translation>가장 느린 시점의 fps</translation>
    </message>
    <message>
        <source>Share of the headroom, %</source>
        <translation>여유 중 비율, %</translation>
    </message>
    <message>
        <source>Culled triangles, %</source>
        <translation>제외된 삼각형, %</translation>
    </message>
    <message>
        <source>Culling, % of the frame</source>
        <translation>컬링, 프레임의 %</translation>
    </message>
    <message>
        <source>Build time, ms</source>
        <translation>구축 시간, ms</translation>
    </message>
    <message>
        <source>Structure, bytes</source>
        <translation>자료구조, 바이트</translation>
    </message>
    <message>
        <source>Missed per million</source>
        <translation>백만분의 놓침</translation>
    </message>
    <message>
        <source>Largest hole, pixels</source>
        <translation>가장 큰 구멍, 픽셀</translation>
    </message>
    <message>
        <source>shape: exact set</source>
        <translation>모양: 정확</translation>
    </message>
    <message>
        <source>shape: lossless</source>
        <translation>모양: 무손실</translation>
    </message>
    <message>
        <source>shape: lossy</source>
        <translation>모양: 손실</translation>
    </message>
    <message>
        <source>There is no figure &quot;%1&quot;; there are %2.</source>
        <translation>&quot;%1&quot; 지표는 없습니다. 있는 것은 %2입니다.</translation>
    </message>
    <message>
        <source>0 (&lt; 3/%1)</source>
        <translation>0 (&lt; 3/%1)</translation>
    </message>
    <message>
        <source>front: nothing lost</source>
        <translation>파레토 경계: 잃은 것 없음</translation>
    </message>
    <message>
        <source>front: something lost</source>
        <translation>파레토 경계: 잃은 것 있음</translation>
    </message>
    <message>
        <source>trying views</source>
        <translation>시점을 시험하는 중</translation>
    </message>
    <message>
        <source>azimuth of the eye, degrees</source>
        <translation>눈의 방위각, 도</translation>
    </message>
    <message>
        <source>elevation of the eye, degrees</source>
        <translation>눈의 고도각, 도</translation>
    </message>
    <message>
        <source>the worst view</source>
        <translation>최악의 시점</translation>
    </message>
    <message>
        <source>plan of the places: x</source>
        <translation>위치 평면도: x</translation>
    </message>
    <message>
        <source>No view was tried.</source>
        <translation>시험한 시점이 없습니다.</translation>
    </message>
    <message>
        <source>%1 gains least where it has ×%2 the speed of drawing the same sides; %3 views were tried.</source>
        <translation>%1: 이득이 가장 작은 곳은 같은 면을 그릴 때의 ×%2 속도입니다. 시점 %3개를 시험했습니다.</translation>
    </message>
    <message>
        <source>%1 lost nothing in %2 views (&lt; 3/%2).</source>
        <translation>%1: 시점 %2개에서 아무것도 잃지 않았습니다(&lt; 3/%2).</translation>
    </message>
    <message>
        <source>%1 loses most where it loses %2 of %3 covered pixels; it loses something in %4 of %5 views.</source>
        <translation>%1: 가장 많이 잃는 곳에서 덮인 픽셀 %3개 중 %2개를 잃습니다. 시점 %5개 중 %4개에서 무언가를 잃습니다.</translation>
    </message>
    <message>
        <source>Missed of a million covered pixels: %1</source>
        <translation>덮인 백만 픽셀 중 놓침: %1</translation>
    </message>
    <message>
        <source>Speed against drawing the same sides: %1</source>
        <translation>같은 면 그리기 대비 속도: %1</translation>
    </message>
    <message>
        <source>false negatives, triangles, %</source>
        <translation>거짓 음성, 삼각형, %</translation>
    </message>
    <message>
        <source>false positives, triangles, %</source>
        <translation>거짓 양성, 삼각형, %</translation>
    </message>
    <message>
        <source>false negatives, objects, %</source>
        <translation>거짓 음성, 물체, %</translation>
    </message>
    <message>
        <source>false positives, objects, %</source>
        <translation>거짓 양성, 물체, %</translation>
    </message>
    <message>
        <source>missed of the covered pixels, ppm</source>
        <translation>덮인 픽셀 중 놓침, ppm</translation>
    </message>
    <message>
        <source>pixel errors, ppm</source>
        <translation>픽셀 오류, ppm</translation>
    </message>
    <message>
        <source>popping, events per 1,000 frames</source>
        <translation>튐, 프레임 1,000개당 사건</translation>
    </message>
    <message>
        <source>popping, pixels</source>
        <translation>튐, 픽셀</translation>
    </message>
    <message>
        <source>popping, duration in frames</source>
        <translation>튐, 지속 프레임</translation>
    </message>
    <message>
        <source>popping, pixels that change, ppm</source>
        <translation>튐, 바뀌는 픽셀, ppm</translation>
    </message>
    <message>
        <source>image difference, mean, ppm</source>
        <translation>그림 차이, 평균, ppm</translation>
    </message>
    <message>
        <source>silhouette error, pixels</source>
        <translation>윤곽 오차, 픽셀</translation>
    </message>
    <message>
        <source>image difference, p99, %</source>
        <translation>그림 차이, p99, %</translation>
    </message>
    <message>
        <source>pixel errors of the worst view, ppm</source>
        <translation>최악 시점의 픽셀 오류, ppm</translation>
    </message>
    <message>
        <source>%1 is no history of experiments: it is passed over.</source>
        <translation>%1 파일은 실험 기록이 아니므로 무시합니다.</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>objects hidden one by one</source>
        <translation>하나씩 가려진 물체</translation>
    </message>
    <message>
        <source>objects that occlude</source>
        <translation>가리는 물체</translation>
    </message>
    <message>
        <source>walk and occluders</source>
        <translation>순회와 가림체</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, whose box no occluder hides.</source>
        <translation>물체 %1개의 그룹에 있으며, 그 상자를 가리는 가림체가 없습니다.</translation>
    </message>
    <message>
        <source>Occluders</source>
        <translation>가림체</translation>
    </message>
    <message>
        <source>&amp;Occluders</source>
        <translation>가림체(&amp;O)</translation>
    </message>
    <message>
        <source>Show in the active view which triangles hide what lies behind them</source>
        <translation>어느 삼각형이 뒤에 있는 것을 가리는지 활성 뷰에 표시합니다</translation>
    </message>
    <message>
        <source>drawn as an occluder</source>
        <translation>가림체로 그려짐</translation>
    </message>
    <message>
        <source>ask the buffer: is its box hidden?</source>
        <translation>버퍼에 묻기: 상자가 가려지는가?</translation>
    </message>
    <message>
        <source>yes: hidden, leave all its objects out</source>
        <translation>예: 가려짐, 그 물체를 모두 제외</translation>
    </message>
    <message>
        <source>no: visit(parts), nearest first</source>
        <translation>아니요: 가까운 것부터 visit(부분)</translation>
    </message>
    <message>
        <source>an object: test and ask likewise</source>
        <translation>물체: 똑같이 검사하고 묻기</translation>
    </message>
    <message>
        <source>not hidden: put it into the buffer</source>
        <translation>가려지지 않음: 버퍼에 넣기</translation>
    </message>
    <message>
        <source>ask again about each object kept</source>
        <translation>남긴 물체마다 다시 묻기</translation>
    </message>
    <message>
        <source>How many pixels the triangles of an occluder have on average, seen face on: smaller ones hide little.</source>
        <translation>가림체의 삼각형을 정면에서 보았을 때의 평균 픽셀 수. 더 작은 것은 거의 가리지 못합니다.</translation>
    </message>
    <message>
        <source>How many triangles all occluders of a frame may have together.</source>
        <translation>한 프레임의 모든 가림체가 합쳐서 가질 수 있는 삼각형 수.</translation>
    </message>
    <message>
        <source>What occluders hid</source>
        <translation>가림체가 가린 것</translation>
    </message>
    <message>
        <source>Occlusion by a depth buffer in software</source>
        <translation>소프트웨어 깊이 버퍼에 의한 가림</translation>
    </message>
    <message>
        <source>Draws the largest triangles of near objects into a depth buffer on the processor, and leaves out what lies behind them.</source>
        <translation>가까운 물체의 가장 큰 삼각형을 프로세서에서 깊이 버퍼에 그리고, 그 뒤에 있는 것을 제외합니다.</translation>
    </message>
    <message>
        <source>Masked occlusion in software</source>
        <translation>소프트웨어 마스크 가림</translation>
    </message>
    <message>
        <source>As occlusion by a depth buffer, with two depths and a mask for 32 pixels: much faster, and hides nearly as much.</source>
        <translation>깊이 버퍼에 의한 가림과 같지만 32픽셀마다 깊이 두 개와 마스크 하나를 씁니다. 훨씬 빠르고 거의 그만큼 가립니다.</translation>
    </message>
    <message>
        <source>Its %1 largest triangles go into the buffer: facing the eye at its nearest point they have at least %2 pixels on average.</source>
        <translation>가장 큰 삼각형 %1개가 버퍼에 들어갑니다. 가장 가까운 점에서 정면으로 보면 평균 %2픽셀 이상입니다.</translation>
    </message>
    <message>
        <source>Nothing is in the buffer yet that could hide its box: it counts as visible.</source>
        <translation>상자를 가릴 수 있는 것이 아직 버퍼에 없습니다. 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and occluders hide each of them.</source>
        <translation>삼각형은 더 작은 상자 %1개에 있고, 가림체가 그 모두를 가립니다.</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and occluders do not hide all of them.</source>
        <translation>삼각형은 더 작은 상자 %1개에 있고, 가림체가 그 모두를 가리지는 못합니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, reaches before the near plane or lies beside the picture: it counts as visible.</source>
        <translation>%1만큼 키운 상자가 가까운 평면 앞까지 닿거나 그림 옆에 있습니다. 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: one of them shows no occluder, so it counts as visible.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작해 많아야 %3픽셀을 덮습니다. 그 가운데 가림체가 없는 픽셀이 있으므로 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, the farthest %4 ahead, which hide it.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작해 많아야 %3픽셀을 덮습니다. 모두에 가림체가 있고 가장 먼 것이 앞쪽 %4에 있어 상자를 가립니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead and covers at most %3 pixels: all show occluders, but the farthest is %4 ahead, so it counts as visible.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작해 많아야 %3픽셀을 덮습니다. 모두에 가림체가 있지만 가장 먼 것이 앞쪽 %4에 있으므로 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>clusters of triangles</source>
        <translation>삼각형 클러스터</translation>
    </message>
    <message>
        <source>bounds of the clusters</source>
        <translation>클러스터의 경계</translation>
    </message>
    <message>
        <source>whole clusters of triangles of which anything is visible</source>
        <translation>일부라도 보이는 삼각형 클러스터 전체</translation>
    </message>
    <message>
        <source>clusters</source>
        <translation>클러스터</translation>
    </message>
    <message>
        <source>occluders</source>
        <translation>가림체</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; is tested as one box, then by its clusters; it has %2 triangles.</source>
        <translation>&quot;%1&quot; 물체는 먼저 상자 하나로, 그다음 클러스터별로 검사됩니다. 삼각형은 %2개입니다.</translation>
    </message>
    <message>
        <source>Boxes of clusters</source>
        <translation>클러스터의 상자</translation>
    </message>
    <message>
        <source>Boxes of cl&amp;usters</source>
        <translation>클러스터의 상자(&amp;U)</translation>
    </message>
    <message>
        <source>Show in the active view the boxes of the clusters, or of groups of them that were decided together, by what became of them</source>
        <translation>활성 뷰에 클러스터의 상자, 또는 함께 결정된 클러스터 묶음의 상자를 결과에 따라 표시합니다</translation>
    </message>
    <message>
        <source>hidden by nearer ones: leave it out</source>
        <translation>더 가까운 것에 가려짐: 제외</translation>
    </message>
    <message>
        <source>else it occludes those behind it</source>
        <translation>아니면 뒤의 것을 가림</translation>
    </message>
    <message>
        <source>box hidden: leave it out</source>
        <translation>상자가 가려짐: 제외</translation>
    </message>
    <message>
        <source>Clusters of triangles</source>
        <translation>삼각형 클러스터</translation>
    </message>
    <message>
        <source>Cuts meshes into clusters of neighbouring triangles and tests these, from large groups to single ones, against the frustum, by the cones of their normals and by what lies before them: loses nothing on any mesh.</source>
        <translation>메시를 이웃한 삼각형의 클러스터로 나누고, 큰 묶음에서 하나하나까지 절두체, 법선 원뿔, 그리고 앞에 놓인 것으로 검사합니다. 어떤 메시에서도 아무것도 잃지 않습니다.</translation>
    </message>
    <message>
        <source>it is not</source>
        <translation>알아내지 않음</translation>
    </message>
    <message>
        <source>a depth for every pixel</source>
        <translation>픽셀마다 깊이 하나</translation>
    </message>
    <message>
        <source>two depths and a mask for each 8 × 4 pixels</source>
        <translation>8 × 4픽셀마다 깊이 둘과 마스크 하나</translation>
    </message>
    <message>
        <source>Whether clusters whose triangles all face away are left out (where only front sides are drawn).</source>
        <translation>삼각형이 모두 뒤를 향하는 클러스터를 제외할지 여부(앞면만 그릴 때).</translation>
    </message>
    <message>
        <source>How many triangles a cluster has at most. An object of no more is one cluster.</source>
        <translation>클러스터 하나의 최대 삼각형 수. 그보다 많지 않은 물체는 클러스터 하나입니다.</translation>
    </message>
    <message>
        <source>back sides of what is drawn</source>
        <translation>그려진 부분의 뒷면</translation>
    </message>
    <message>
        <source>perpendicular axis</source>
        <translation>수직축</translation>
    </message>
    <message>
        <source>to the eye</source>
        <translation>눈 쪽으로</translation>
    </message>
    <message>
        <source>R of the largest S, from the origin O</source>
        <translation>가장 큰 S의 R, 원점 O에서</translation>
    </message>
    <message>
        <source>front: from the eye</source>
        <translation>앞면: 눈에서</translation>
    </message>
    <message>
        <source>back: from the opposite side, into the hollow shell</source>
        <translation>뒷면: 반대쪽에서, 빈 껍질 속을 들여다봄</translation>
    </message>
    <message>
        <source>its back sides, seen from within: the darker, the deeper in the hollow</source>
        <translation>그 뒷면, 안쪽에서 봄: 움푹한 곳이 깊을수록 어두움</translation>
    </message>
    <message>
        <source>the same point P in both</source>
        <translation>두 그림의 같은 점 P</translation>
    </message>
    <message>
        <source>Ray %1: its R beside that of the triangles of each cell</source>
        <translation>광선 %1: 각 셀의 삼각형의 R과 나란히 놓은 광선의 R</translation>
    </message>
    <message>
        <source>R of the triangles of a cell</source>
        <translation>셀의 삼각형의 R</translation>
    </message>
    <message>
        <source>R of the ray</source>
        <translation>광선의 R</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>교차</translation>
    </message>
    <message>
        <source>corner ray; pale is what lies behind a surface</source>
        <translation>모서리 광선; 면 뒤의 부분은 흐림</translation>
    </message>
    <message>
        <source>Once for each mesh</source>
        <translation>메시마다 한 번</translation>
    </message>
    <message>
        <source>For each object, in every frame</source>
        <translation>매 프레임, 물체마다</translation>
    </message>
    <message>
        <source>%1, byte %2: the text of the level&apos;s entities cannot be read here. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 레벨의 엔티티 텍스트를 여기서 읽을 수 없습니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: an array of the level ends within a record. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 레벨의 배열이 레코드 중간에서 끝납니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1 does not begin with IBSP, as levels of Quake 3 do. Levels of other games are not read: convert them to a mesh.</source>
        <translation>%1 파일은 Quake 3 레벨처럼 IBSP로 시작하지 않습니다. 다른 게임의 레벨은 읽지 않으니 메시로 변환하십시오.</translation>
    </message>
    <message>
        <source>%1 is a level of version %2; only version %3, that of Quake 3, is read. Convert it to a mesh.</source>
        <translation>%1 파일은 버전 %2의 레벨입니다. Quake 3의 버전 %3만 읽습니다. 메시로 변환하십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: an array of the level is to end at byte %3, after the end of the file. The file was cut off or changed: fetch it again.</source>
        <translation>%1, 바이트 %2: 레벨의 배열이 파일 끝을 지난 바이트 %3에서 끝난다고 되어 있습니다. 파일이 잘렸거나 변경되었으니 다시 받으십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: there is no surface of kind %3. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 종류 %3의 표면은 없습니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: a patch has %3 control points; the sides are odd numbers from 3 on, and their product is the number of vertices. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 패치의 제어점이 %3개입니다. 각 변은 3 이상의 홀수이고 그 곱이 정점 수여야 합니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: the node %3 of the BSP tree has two parents. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: BSP 트리의 노드 %3에 부모가 둘 있습니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: the file has no room for which of %3 clusters see which. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 클러스터 %3개의 상호 가시성을 담을 자리가 파일에 없습니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>Surfaces left out that the game does not draw, or draws as sky: %1.</source>
        <translation>게임이 그리지 않거나 하늘로 그려서 제외한 표면: %1개.</translation>
    </message>
    <message>
        <source>Billboards left out, which have no place of their own: %1.</source>
        <translation>고유한 위치가 없어 제외한 빌보드: %1개.</translation>
    </message>
    <message>
        <source>Surfaces left out of models that no entity places: %1.</source>
        <translation>어떤 엔티티도 배치하지 않는 모델에서 제외한 표면: %1개.</translation>
    </message>
    <message>
        <source>%1, byte %2: the record here names %3 items from number %4 on, but the file has %5 of them. Fetch or compile the level again.</source>
        <translation>%1, 바이트 %2: 여기 레코드는 %4번부터 항목 %3개를 가리키지만 파일에는 %5개가 있습니다. 레벨을 다시 받거나 컴파일하십시오.</translation>
    </message>
    <message>
        <source>%1 names the accessor %2, which it does not have. Export the file again.</source>
        <translation>%1 파일이 가리키는 접근자 %2번이 파일에 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 takes its numbers from where the file has no buffer. The file was cut off or changed: fetch or export it again.</source>
        <translation>%1: 접근자 %2번이 버퍼가 없는 곳에서 숫자를 읽습니다. 파일이 잘렸거나 변경되었으니 다시 받거나 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 has more elements than its buffer view has room for. The file was cut off or changed: fetch or export it again.</source>
        <translation>%1: 접근자 %2번의 요소가 버퍼 뷰에 담을 수 있는 것보다 많습니다. 파일이 잘렸거나 변경되었으니 다시 받거나 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 does not have %3 numbers an element of a kind that can stand there. Export the file again.</source>
        <translation>%1: 접근자 %2번의 요소가 여기에 올 수 있는 종류의 숫자 %3개로 되어 있지 않습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 replaces elements in a way that is not possible. Export the file again.</source>
        <translation>%1: 접근자 %2번이 불가능한 방식으로 요소를 바꿉니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 replaces an element that it does not have. Export the file again.</source>
        <translation>%1: 접근자 %2번이 없는 요소를 바꿉니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the accessor %2 has to have whole numbers without a sign. Export the file again.</source>
        <translation>%1: 접근자 %2번은 부호 없는 정수여야 합니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: objects and arrays lie deeper in each other than %3. Export the file again.</source>
        <translation>%1, 바이트 %2: 객체와 배열이 %3단계보다 깊이 중첩되어 있습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: this is glTF of version %3; only version 2 is read. Export the scene as glTF 2.0.</source>
        <translation>%1, 바이트 %2: glTF 버전 %3입니다. 버전 2만 읽습니다. 장면을 glTF 2.0으로 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: a chunk is to have %3 bytes, more than the file. The file was cut off or changed: fetch it again.</source>
        <translation>%1, 바이트 %2: 청크가 파일보다 긴 %3바이트라고 되어 있습니다. 파일이 잘렸거나 변경되었으니 다시 받으십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: the file is to have %3 bytes and has fewer. The file was cut off: fetch it again.</source>
        <translation>%1, 바이트 %2: 파일이 %3바이트라고 되어 있지만 더 짧습니다. 파일이 잘렸으니 다시 받으십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: a chunk of JSON must stand here. Export the file again.</source>
        <translation>%1, 바이트 %2: 여기에는 JSON 청크가 있어야 합니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1, byte %2: the chunk has %3 bytes, which is no multiple of 4. Export the file again.</source>
        <translation>%1, 바이트 %2: 청크의 길이 %3바이트가 4의 배수가 아닙니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: a mesh that is compressed with Draco does not have its attribute %2. Export the file again.</source>
        <translation>%1: Draco로 압축된 메시에 속성 %2번이 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: a mesh that is compressed with Draco cannot be decoded: %2. Fetch or export the file again.</source>
        <translation>%1: Draco로 압축된 메시를 풀 수 없습니다: %2. 파일을 다시 받거나 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: a mesh is compressed with a version of Draco that is not read. Export the file again.</source>
        <translation>%1: 읽지 않는 버전의 Draco로 압축된 메시가 있습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 places no surface that can be shown in its scene. Export the scene with its meshes.</source>
        <translation>%1 파일은 장면에 표시할 수 있는 표면을 배치하지 않습니다. 장면을 메시와 함께 내보내십시오.</translation>
    </message>
    <message>
        <source>Points and lines left out, which have no surface: %1 primitives.</source>
        <translation>표면이 없어 제외한 점과 선: 프리미티브 %1개.</translation>
    </message>
    <message>
        <source>Primitives left out that have no positions: %1.</source>
        <translation>위치가 없어 제외한 프리미티브: %1개.</translation>
    </message>
    <message>
        <source>Objects left out that lie beyond 1e30: %1.</source>
        <translation>1e30을 벗어나 제외한 물체: %1개.</translation>
    </message>
    <message>
        <source>Skins are not applied; objects that stand as they were modelled: %1.</source>
        <translation>스킨을 적용하지 않아 모델링된 상태로 서 있는 물체: %1개.</translation>
    </message>
    <message>
        <source>Morph targets are not applied; primitives that have some: %1.</source>
        <translation>모프 타깃을 적용하지 않습니다. 모프 타깃이 있는 프리미티브: %1개.</translation>
    </message>
    <message>
        <source>Animations are not played: %1.</source>
        <translation>재생하지 않는 애니메이션: %1개.</translation>
    </message>
    <message>
        <source>Scenes of the file that are not shown, because one at a time is: %1.</source>
        <translation>한 번에 하나만 표시하므로 표시하지 않은 파일의 장면: %1개.</translation>
    </message>
    <message>
        <source>%1 takes a buffer from &quot;%2&quot;, which is not in its own folder or below. Put the buffers beside it, or export it as one file (.glb).</source>
        <translation>%1 파일이 자신의 폴더나 그 아래에 없는 &quot;%2&quot;에서 버퍼를 읽습니다. 버퍼를 파일 옆에 두거나 한 파일(.glb)로 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 takes a buffer from &quot;%2&quot;, which does not exist. Put the buffers beside it, or export it as one file (.glb).</source>
        <translation>%1 파일이 없는 파일 &quot;%2&quot;에서 버퍼를 읽습니다. 버퍼를 파일 옆에 두거나 한 파일(.glb)로 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 has more than 4 GB. Split the file, or put its buffers into files beside it.</source>
        <translation>%1 파일이 4GB보다 큽니다. 파일을 나누거나 버퍼를 옆의 파일에 두십시오.</translation>
    </message>
    <message>
        <source>%1 cannot be read as glTF 2.0: %2. Export the file again.</source>
        <translation>%1 파일을 glTF 2.0으로 읽을 수 없습니다: %2. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 requires the extension &quot;%2&quot;, which is not read. Export the file without it.</source>
        <translation>%1 파일에 필요한 &quot;%2&quot; 확장을 읽지 못합니다. 그 확장 없이 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 names the scene %2, which it does not have. Export the file again.</source>
        <translation>%1 파일이 가리키는 장면 %2번이 파일에 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 names the node %2, which it does not have. Export the file again.</source>
        <translation>%1 파일이 가리키는 노드 %2번이 파일에 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the node %2 has two parents or is its own ancestor. Export the file again.</source>
        <translation>%1: 노드 %2번에 부모가 둘 있거나 노드가 자신의 조상입니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the transform of the node %2 does not have the numbers that it needs. Export the file again.</source>
        <translation>%1: 노드 %2번의 변환에 필요한 숫자가 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the matrix of the node %2 is not affine. Export the file again.</source>
        <translation>%1: 노드 %2번의 행렬이 아핀 변환이 아닙니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 names the mesh %2, which it does not have. Export the file again.</source>
        <translation>%1 파일이 가리키는 메시 %2번이 파일에 없습니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>%1: the instances of the node %2 have transforms of different numbers. Export the file again.</source>
        <translation>%1: 노드 %2번의 인스턴스 변환들의 개수가 서로 다릅니다. 파일을 다시 내보내십시오.</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1; its answers come later</source>
        <translation>OpenGL에 묻는 상자: %1개, 답은 나중에 옵니다</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1, in groups: %2; its answers come later</source>
        <translation>OpenGL에 묻는 상자: %1개, 묶음: %2개, 답은 나중에 옵니다</translation>
    </message>
    <message>
        <source>OpenGL is asked about boxes: %1, in groups: %2; groups hit: %3</source>
        <translation>OpenGL에 묻는 상자: %1개, 묶음: %2개, 맞은 묶음: %3개</translation>
    </message>
    <message>
        <source>OpenGL cannot be asked about a group of no boxes.</source>
        <translation>상자가 없는 묶음은 OpenGL에 물을 수 없습니다.</translation>
    </message>
    <message>
        <source>OpenGL is asked about %1 boxes, and their groups have %2 boxes: each box belongs to one group.</source>
        <translation>OpenGL에 상자 %1개를 묻는데 그 묶음의 상자는 %2개입니다. 상자는 저마다 한 묶음에 속해야 합니다.</translation>
    </message>
    <message>
        <source>It was visible in the frame before: it counts as visible without asking.</source>
        <translation>앞 프레임에서 보였습니다. 묻지 않고 보이는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>There is no answer about it of the frame before: it counts as visible.</source>
        <translation>앞 프레임의 답이 없습니다. 보이는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>At the end of the frame OpenGL is asked about it, for the next frame: boxes: %1.</source>
        <translation>프레임 끝에 다음 프레임을 위해 OpenGL에 묻습니다. 상자: %1개.</translation>
    </message>
    <message>
        <source>By the answers of the frame before it is hidden; it is asked about for the next frame, boxes: %1.</source>
        <translation>앞 프레임의 답에 따르면 가려졌습니다. 다음 프레임을 위해 묻습니다. 상자: %1개.</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1; it shows before what is drawn.</source>
        <translation>OpenGL에 물었습니다. 상자: %1개. 그려진 것 앞에 보입니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1; what is drawn hides all of it.</source>
        <translation>OpenGL에 물었습니다. 상자: %1개. 그려진 것이 모두 가립니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1, and others at once, together %2; of these something shows, so each is asked about by itself.</source>
        <translation>OpenGL에 다른 그룹과 함께 한 번에 물었습니다. 상자: %1개, 그룹: 모두 %2개. 그중 무언가가 보이므로 하나씩 다시 묻습니다.</translation>
    </message>
    <message>
        <source>OpenGL was asked about it, boxes: %1, and others at once, together %2; what is drawn hides all of them.</source>
        <translation>OpenGL에 다른 그룹과 함께 한 번에 물었습니다. 상자: %1개, 그룹: 모두 %2개. 그려진 것이 모두를 가립니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, reaches before the near plane: it counts as visible without asking.</source>
        <translation>%1만큼 키운 상자가 근평면 앞까지 닿습니다. 묻지 않고 보이는 것으로 봅니다.</translation>
    </message>
    <message>
        <source>visit the nearest group left</source>
        <translation>남은 그룹 중 가장 가까운 것을 방문</translation>
    </message>
    <message>
        <source>first, near or visible before: visible</source>
        <translation>첫째, 근평면, 앞서 보였으면: 보임</translation>
    </message>
    <message>
        <source>a leaf and due: ask again at the end</source>
        <translation>잎이고 차례이면: 끝에 다시 물음</translation>
    </message>
    <message>
        <source>else ask OpenGL, several in one query</source>
        <translation>아니면 여럿을 한 질의로 OpenGL에 물음</translation>
    </message>
    <message>
        <source>some of several show: ask one by one</source>
        <translation>여럿 중 일부가 보이면: 하나씩 물음</translation>
    </message>
    <message>
        <source>visible: visit(parts), nearest first</source>
        <translation>보이면: 방문(부분), 가까운 것부터</translation>
    </message>
    <message>
        <source>Coherent hierarchical culling (CHC++)</source>
        <translation>일관성 계층 컬링(CHC++)</translation>
    </message>
    <message>
        <source>Draws what was visible in the frame before, and asks OpenGL about what was hidden, many groups at once.</source>
        <translation>앞 프레임에서 보인 것을 그리고, 가려졌던 것은 여러 그룹을 한 번에 OpenGL에 묻습니다.</translation>
    </message>
    <message>
        <source>How many frames later answers about hidden groups are used; 0: they are waited for, and nothing is lost.</source>
        <translation>가려진 그룹에 대한 답을 몇 프레임 뒤에 쓰는지; 0: 답을 기다리며 아무것도 잃지 않습니다.</translation>
    </message>
    <message>
        <source>How many groups that were hidden are gathered before OpenGL is asked about them.</source>
        <translation>가려졌던 그룹을 몇 개 모은 뒤 OpenGL에 묻는지.</translation>
    </message>
    <message>
        <source>How many groups one query covers at most; 1: each has a query of its own.</source>
        <translation>한 질의가 다루는 그룹의 최대 수; 1: 그룹마다 따로 묻습니다.</translation>
    </message>
    <message>
        <source>After how many frames a visible group without parts is asked about again.</source>
        <translation>부분이 없는 보이는 그룹을 몇 프레임 뒤에 다시 묻는지.</translation>
    </message>
    <message>
        <source>After how many frames that is done for the first time.</source>
        <translation>처음에는 몇 프레임 뒤에 다시 묻는지.</translation>
    </message>
    <message>
        <source>a random part of these frames, so that the queries spread</source>
        <translation>그 프레임 수의 임의의 일부: 질의가 고르게 퍼집니다</translation>
    </message>
    <message>
        <source>all of these frames</source>
        <translation>그 프레임 수 전부</translation>
    </message>
    <message>
        <source>How many levels below a group lie the boxes by which it is asked about, at most; 0: by its own box.</source>
        <translation>그룹을 물을 때 쓰는 상자가 그룹보다 최대 몇 단계 아래에 있는지; 0: 그룹 자신의 상자.</translation>
    </message>
    <message>
        <source>How many times the surface of the group&apos;s own box these boxes have together, at most.</source>
        <translation>이 상자들의 겉넓이 합이 그룹 자신의 상자의 최대 몇 배인지.</translation>
    </message>
    <message>
        <source>nothing drawn beyond</source>
        <translation>이 너머로는 그리지 않음</translation>
    </message>
    <message>
        <source>α is the angle from the sight ray, seen from the middle of the sphere: the paper&apos;s near half, up to 180° across, has α up to 90°.</source>
        <translation>α는 구의 중심에서 본 시선과의 각도입니다. 논문이 말하는 180°까지의 가까운 쪽 절반은 α가 90° 이하입니다.</translation>
    </message>
    <message>
        <source>from the side, as in Figures 5 to 7, with what is left out</source>
        <translation>옆에서(그림 5~7과 같음), 그리지 않는 부분과 함께</translation>
    </message>
    <message>
        <source>the way of the view in this figure</source>
        <translation>이 그림의 시점이 지나는 길</translation>
    </message>
    <message>
        <source>The scene has no view cells: it has less than two objects, or too many triangles. Each object may be visible.</source>
        <translation>장면에 시야 셀이 없습니다. 물체가 둘보다 적거나 삼각형이 너무 많습니다. 모든 물체가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>The sets are made for surfaces that hide from both sides, and this frame draws fronts alone: each object may be visible.</source>
        <translation>집합은 양쪽에서 가리는 면을 위해 만들었는데 이 프레임은 앞면만 그립니다. 모든 물체가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>The eye lies in no view cell: each object may be visible.</source>
        <translation>눈이 어느 시야 셀에도 있지 않습니다. 모든 물체가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>The near plane or the pixels of this view are beyond what the proofs allow for: each object may be visible.</source>
        <translation>이 뷰의 근평면이나 픽셀이 증명이 허용하는 범위를 벗어납니다. 모든 물체가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>The eye lies in view cell %1, from which %2 objects may be seen.</source>
        <translation>눈이 시야 셀 %1에 있으며, 여기서 물체 %2개가 보일 수 있습니다.</translation>
    </message>
    <message>
        <source>objects not in the cell&apos;s set</source>
        <translation>셀의 집합에 없는 물체</translation>
    </message>
    <message>
        <source>objects outside the frustum</source>
        <translation>절두체 밖의 물체</translation>
    </message>
    <message>
        <source>The culling eye lies in no view cell.</source>
        <translation>컬링하는 눈이 어느 시야 셀에도 있지 않습니다.</translation>
    </message>
    <message>
        <source>sets=%1: the scene came without potentially visible sets, which levels of Quake 3 (.bsp) have. Take %2 or %3.</source>
        <translation>sets=%1: 장면에 잠재적 가시 집합이 딸려 오지 않았습니다. Quake 3 레벨(.bsp)에는 있습니다. %2 또는 %3을(를) 쓰십시오.</translation>
    </message>
    <message>
        <source>the cell&apos;s set</source>
        <translation>셀의 집합</translation>
    </message>
    <message>
        <source>The object &quot;%1&quot; has %2 triangles, which the cell&apos;s set has together or not at all.</source>
        <translation>물체 &quot;%1&quot;에는 삼각형이 %2개 있으며, 셀의 집합은 이를 모두 담거나 하나도 담지 않습니다.</translation>
    </message>
    <message>
        <source>View cell</source>
        <translation>시야 셀</translation>
    </message>
    <message>
        <source>View &amp;cell</source>
        <translation>시야 셀(&amp;C)</translation>
    </message>
    <message>
        <source>Show in the active view the cell from anywhere in which the drawn objects may be seen</source>
        <translation>그린 물체가 그 안 어디에서든 보일 수 있는 셀을 활성 뷰에 표시</translation>
    </message>
    <message>
        <source>view cell of the culling eye</source>
        <translation>컬링하는 눈의 시야 셀</translation>
    </message>
    <message>
        <source>find the view cell of the eye</source>
        <translation>눈의 시야 셀을 찾음</translation>
    </message>
    <message>
        <source>none: each object is in the set</source>
        <translation>없으면: 모든 물체가 집합에 있음</translation>
    </message>
    <message>
        <source>not in the cell&apos;s set: leave it out</source>
        <translation>셀의 집합에 없으면: 제외</translation>
    </message>
    <message>
        <source>test it against the frustum</source>
        <translation>절두체로 검사</translation>
    </message>
    <message>
        <source>Potentially visible sets</source>
        <translation>잠재적 가시 집합</translation>
    </message>
    <message>
        <source>Draws what may be seen from anywhere in the eye&apos;s cell, worked out beforehand for all cells.</source>
        <translation>눈이 있는 셀의 어디에서든 보일 수 있는 것을 그리며, 모든 셀에 대해 미리 계산합니다.</translation>
    </message>
    <message>
        <source>Where the cells&apos; sets come from.</source>
        <translation>셀의 집합을 어디서 얻는지.</translation>
    </message>
    <message>
        <source>what rays from the cell meet</source>
        <translation>셀에서 나간 광선이 만나는 것</translation>
    </message>
    <message>
        <source>all but what is proven to be hidden from the cell</source>
        <translation>셀에서 가려짐이 증명된 것을 뺀 모두</translation>
    </message>
    <message>
        <source>the sets that came with the scene&apos;s file</source>
        <translation>장면 파일에 딸려 온 집합</translation>
    </message>
    <message>
        <source>How many cells lie along the longest side of the scene.</source>
        <translation>장면의 가장 긴 변을 따라 놓이는 셀의 수.</translation>
    </message>
    <message>
        <source>How many more times a cell is halved that a surface crosses.</source>
        <translation>면이 지나는 셀을 몇 번 더 반으로 나누는지.</translation>
    </message>
    <message>
        <source>How many rays look around from a cell.</source>
        <translation>한 셀에서 둘러보는 광선의 수.</translation>
    </message>
    <message>
        <source>Whether a cell&apos;s sampled set also has what the cells beside it see.</source>
        <translation>셀의 표본 집합에 옆 셀들이 보는 것도 넣을지.</translation>
    </message>
    <message>
        <source>What the rays&apos; random numbers begin with.</source>
        <translation>광선의 난수가 시작하는 값.</translation>
    </message>
    <message>
        <source>What the cell&apos;s set has</source>
        <translation>셀의 집합에 있는 것</translation>
    </message>
    <message>
        <source>Rays from view cells</source>
        <translation>시야 셀에서 나가는 광선</translation>
    </message>
    <message>
        <source>Proofs of what is hidden</source>
        <translation>가려진 것의 증명</translation>
    </message>
    <message>
        <source>A strategy draws %1 ranges by the answers to a question that has %2: each range needs one.</source>
        <translation>전략이 %1개 범위를 답이 %2개인 질문에 따라 그리려 합니다. 범위마다 답이 하나 있어야 합니다.</translation>
    </message>
    <message>
        <source>objects drawn first</source>
        <translation>먼저 그린 물체</translation>
    </message>
    <message>
        <source>objects tested</source>
        <translation>검사한 물체</translation>
    </message>
    <message>
        <source>objects hidden</source>
        <translation>가려진 물체</translation>
    </message>
    <message>
        <source>objects drawn after a test</source>
        <translation>검사한 뒤 그린 물체</translation>
    </message>
    <message>
        <source>objects for the next frame</source>
        <translation>다음 프레임에 먼저 그릴 물체</translation>
    </message>
    <message>
        <source>walk and pyramid</source>
        <translation>순회와 피라미드</translation>
    </message>
    <message>
        <source>It lies in a group of %1 objects, of which some are in the frustum.</source>
        <translation>물체 %1개의 그룹에 있으며, 그 가운데 일부가 절두체 안에 있습니다.</translation>
    </message>
    <message>
        <source>visible before, or near: draw it</source>
        <translation>앞서 보였거나 가까움: 그리기</translation>
    </message>
    <message>
        <source>the others by rounds, nearest first</source>
        <translation>나머지를 차례로, 가까운 것부터</translation>
    </message>
    <message>
        <source>reduce the depth drawn to a pyramid</source>
        <translation>그린 깊이를 피라미드로 줄이기</translation>
    </message>
    <message>
        <source>test boxes against its texels</source>
        <translation>상자를 그 텍셀과 비교</translation>
    </message>
    <message>
        <source>behind all: hidden, leave it out</source>
        <translation>모두의 뒤: 가려짐, 제외</translation>
    </message>
    <message>
        <source>else draw it, in the same frame</source>
        <translation>아니면 같은 프레임에 그리기</translation>
    </message>
    <message>
        <source>reduce again, test all: hidden now</source>
        <translation>다시 줄여 모두 검사: 이제 가려짐</translation>
    </message>
    <message>
        <source>else visible for the next frame</source>
        <translation>아니면 다음 프레임에 보이는 것</translation>
    </message>
    <message>
        <source>Hierarchical depth in two passes</source>
        <translation>두 단계 계층 깊이</translation>
    </message>
    <message>
        <source>Draws what was visible in the frame before, and has the GPU test all else against a pyramid of its depth and draw it in the same frame.</source>
        <translation>앞 프레임에서 보인 것을 그린 다음, 나머지는 그 깊이의 피라미드와 GPU에서 비교해 같은 프레임에 그립니다.</translation>
    </message>
    <message>
        <source>In how many rounds the other objects are tested and drawn, the nearest first: what one draws hides what the next one tests.</source>
        <translation>나머지 물체를 몇 차례에 나누어 가까운 것부터 검사하고 그리는지: 한 차례에 그린 것이 다음 차례에 검사하는 것을 가립니다.</translation>
    </message>
    <message>
        <source>Objects by the depth pyramid</source>
        <translation>깊이 피라미드에 따른 물체</translation>
    </message>
    <message>
        <source>It was visible at the end of the frame before: it is drawn first, without a test.</source>
        <translation>앞 프레임의 끝에서 보였습니다. 검사 없이 먼저 그립니다.</translation>
    </message>
    <message>
        <source>The depth of what is drawn so far is reduced to a pyramid: levels %1; a texel has the farthest depth of the pixels below it.</source>
        <translation>지금까지 그린 것의 깊이를 피라미드로 줄입니다: 단계 %1개. 텍셀은 그 아래 픽셀들의 가장 먼 깊이를 가집니다.</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and each lies behind all texels of the pyramid that it may cover.</source>
        <translation>삼각형은 더 작은 상자 %1개에 있고, 상자마다 덮을 수 있는 피라미드 텍셀 모두의 뒤에 있습니다.</translation>
    </message>
    <message>
        <source>Its triangles lie in %1 smaller boxes, and not all lie behind the texels of the pyramid that they may cover: it counts as visible.</source>
        <translation>삼각형은 더 작은 상자 %1개에 있고, 덮을 수 있는 피라미드 텍셀 뒤에 모두 있지는 않으므로 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the pyramid, %4, one has pixels that show nothing yet: it counts as visible.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작합니다. 피라미드 %3단계에서 덮을 수 있는 텍셀 %4개 가운데 아직 아무것도 없는 픽셀을 가진 것이 있으므로 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. It lies behind all texels that it may cover on level %3 of the pyramid: %4; the farthest is %5 ahead.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작합니다. 피라미드 %3단계에서 덮을 수 있는 텍셀 %4개 모두의 뒤에 있으며, 가장 먼 것이 앞쪽 %5에 있습니다.</translation>
    </message>
    <message>
        <source>Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the pyramid, %4, the farthest is %5 ahead: it counts as visible.</source>
        <translation>%1만큼 키운 상자가 앞쪽 %2에서 시작합니다. 피라미드 %3단계에서 덮을 수 있는 텍셀 %4개 가운데 가장 먼 것이 앞쪽 %5에 있으므로 보이는 것으로 칩니다.</translation>
    </message>
    <message>
        <source>At the end of the frame it is not hidden: the next frame draws it first.</source>
        <translation>프레임의 끝에서 가려지지 않았습니다. 다음 프레임이 먼저 그립니다.</translation>
    </message>
    <message>
        <source>At the end of the frame it is hidden: the next frame does not draw it first.</source>
        <translation>프레임의 끝에서 가려졌습니다. 다음 프레임은 먼저 그리지 않습니다.</translation>
    </message>
    <message>
        <source>boxes of clusters</source>
        <translation>클러스터의 상자</translation>
    </message>
    <message>
        <source>How it is found that clusters are hidden: by large triangles of near objects, drawn on the processor, or by what the frame has drawn.</source>
        <translation>클러스터가 가려졌는지 알아내는 방법: 프로세서에서 그린 가까운 물체의 큰 삼각형으로, 또는 프레임이 이미 그린 것으로.</translation>
    </message>
    <message>
        <source>a pyramid of the depth that the frame has drawn, on the GPU</source>
        <translation>프레임이 그린 깊이의 피라미드로, GPU에서</translation>
    </message>
    <message>
        <source>%1, line %2: &quot;%3&quot; is not a usable number. Write one from -1e30 to 1e30, with a point for decimals.</source>
        <translation>%1, %2행: &quot;%3&quot;은(는) 쓸 수 있는 수가 아닙니다. 소수점은 점으로, -1e30에서 1e30까지의 수를 쓰십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: the polygon has no area. Give it corners around a face, not all on one line.</source>
        <translation>%1, %2행: 다각형에 넓이가 없습니다. 꼭짓점을 면 둘레에, 한 직선 위에만 있지 않게 두십시오.</translation>
    </message>
    <message>
        <source>%1, line %2: the plane&apos;s normal is 0. At least one of its three numbers must not be 0.</source>
        <translation>%1, %2행: 평면의 법선이 0입니다. 세 수 가운데 적어도 하나는 0이 아니어야 합니다.</translation>
    </message>
    <message>
        <source>any hit: region between them</source>
        <translation>하나라도 맞으면 그 사이 영역</translation>
    </message>
    <message>
        <source>back side of a surface</source>
        <translation>표면의 뒷면</translation>
    </message>
    <message>
        <source>plane that the eye is before</source>
        <translation>눈이 앞쪽에 있는 평면</translation>
    </message>
    <message>
        <source>plane that the eye is behind</source>
        <translation>눈이 뒤쪽에 있는 평면</translation>
    </message>
    <message>
        <source>S of a contour band</source>
        <translation>등고선 띠의 S</translation>
    </message>
    <message>
        <source>box of the region</source>
        <translation>영역의 상자</translation>
    </message>
    <message>
        <source>corner ray</source>
        <translation>모서리 광선</translation>
    </message>
    <message>
        <source>height of the sight line with a band&apos;s slope</source>
        <translation>띠의 기울기를 갖는 시선의 높이</translation>
    </message>
    <message>
        <source>Kept as camera %1. Alt+%1 goes back to it.</source>
        <translation>카메라 %1번으로 보관했습니다. Alt+%1로 돌아갑니다.</translation>
    </message>
    <message>
        <source>objects</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>triangles drawn a view</source>
        <translation>뷰마다 그린 삼각형</translation>
    </message>
    <message>
        <source>copies</source>
        <translation>복사본</translation>
    </message>
    <message>
        <source>triangles of the scene</source>
        <translation>장면의 삼각형</translation>
    </message>
    <message>
        <source>Frame time by the size of the scene</source>
        <translation>장면 크기에 따른 프레임 시간</translation>
    </message>
    <message>
        <source>Triangles drawn by the size of the scene</source>
        <translation>장면 크기에 따라 그린 삼각형</translation>
    </message>
    <message>
        <source>Frame time in one of ever more courts</source>
        <translation>점점 많아지는 마당 가운데 하나의 프레임 시간</translation>
    </message>
    <message>
        <source>Each court is a copy of the scene behind walls of its own. All views are of one court, the same for all sizes: what is visible stays the same, while the frustum has more and more in it.</source>
        <translation>마당마다 자기 담장 안에 장면의 복사본이 있습니다. 모든 뷰는 한 마당의 것이며 크기와 상관없이 같습니다. 보이는 것은 그대로인데 절두체 안에 드는 것은 점점 많아집니다.</translation>
    </message>
    <message>
        <source>An exponent of 1 means that the time grows as the scene does, 0 that it does not grow.</source>
        <translation>지수 1은 시간이 장면만큼 늘어남을, 0은 늘지 않음을 뜻합니다.</translation>
    </message>
    <message>
        <source>Frame time in a field of ever more objects</source>
        <translation>점점 많아지는 물체 들판의 프레임 시간</translation>
    </message>
    <message>
        <source>This OpenGL is %1, which draws on the processor. Leave out --gpu for sizes that suit it, or run this where a graphics card draws.</source>
        <translation>이 OpenGL은 프로세서로 그리는 %1입니다. --gpu를 빼면 그에 맞는 크기를 쓰고, 아니면 그래픽 카드가 그리는 곳에서 실행하십시오.</translation>
    </message>
    <message>
        <source>n by n copies of a scene, each behind walls of its own: who stands in one sees no other</source>
        <translation>장면의 복사본 n × n개, 각각 자기 담장 안: 한 마당에서는 다른 마당이 보이지 않습니다</translation>
    </message>
    <message>
        <source>courts along each side</source>
        <translation>한 변의 마당 수</translation>
    </message>
    <message>
        <source>height of the walls, as a share of the scene&apos;s; 0: there are none</source>
        <translation>장면 높이에 대한 담장 높이의 비율, 0: 담장 없음</translation>
    </message>
    <message>
        <source>foot of P in the plane of x and y</source>
        <translation>P에서 xy 평면에 내린 수선의 발</translation>
    </message>
    <message>
        <source>Seen by one camera in Figures 5 to 7: beside the sight ray, which comes from the right, and a little from behind.</source>
        <translation>그림 5~7은 같은 카메라로 본 것임: 오른쪽에서 오는 시선의 옆, 조금 뒤쪽에서.</translation>
    </message>
    <message>
        <source>level of the largest S: beyond α = 90°, bands farther from the eye that stay below it are hidden</source>
        <translation>가장 큰 S의 높이: α = 90° 너머에서 눈에서 더 멀고 이보다 낮은 띠는 가려짐</translation>
    </message>
    <message>
        <source>θ, zenith angle from the z axis</source>
        <translation>θ, z축에서 잰 천정각(고도각)</translation>
    </message>
    <message>
        <source>φ, azimuth from the x axis to the foot of P</source>
        <translation>φ, x축에서 수선의 발까지의 방위각</translation>
    </message>
    <message>
        <source>walk(cell); if open, its parts</source>
        <translation>순회(셀), 안 정해지면 부분마다</translation>
    </message>
    <message>
        <source>few pixels: triangle by triangle</source>
        <translation>픽셀이 적으면: 삼각형마다</translation>
    </message>
    <message>
        <source>Whether triangles that hold no pixel centre or face away are left out of the drawn cells one by one (where the picture has few pixels for each).</source>
        <translation>그리는 셀에서 픽셀 중심이 없거나 등을 돌린 삼각형을 하나씩 제외할지 여부(그림에 삼각형마다 픽셀이 적을 때).</translation>
    </message>
    <message>
        <source>triangles one by one</source>
        <translation>삼각형 하나씩</translation>
    </message>
    <message>
        <source>Of these %1 triangles %2 face away and %3 hold no pixel centre: they are left out one by one.</source>
        <translation>이 삼각형 %1개 중 %2개는 등을 돌렸고 %3개에는 픽셀 중심이 없어, 하나씩 제외합니다.</translation>
    </message>
    <message>
        <source>The triangle faces away, however rounding and snapping move its corners: OpenGL would drop it.</source>
        <translation>반올림과 격자 맞춤이 꼭짓점을 어떻게 옮기든 삼각형은 등을 돌립니다. OpenGL도 버렸을 것입니다.</translation>
    </message>
    <message>
        <source>No pixel centre lies in the triangle, however rounding and snapping move its corners.</source>
        <translation>반올림과 격자 맞춤이 꼭짓점을 어떻게 옮기든 삼각형 안에 픽셀 중심이 없습니다.</translation>
    </message>
    <message>
        <source>facing away, one by one</source>
        <translation>등을 돌림, 하나씩</translation>
    </message>
    <message>
        <source>without a pixel centre</source>
        <translation>픽셀 중심 없음</translation>
    </message>
    <message>
        <source>Normal cones are not used: both sides of the triangles are drawn, the test is switched off, or all of the object is in view and too few of its cells could face away.</source>
        <translation>법선 원뿔을 쓰지 않습니다: 삼각형의 양면을 그리거나, 검사가 꺼져 있거나, 물체 전체가 보이고 뒷면일 수 있는 셀이 너무 적습니다.</translation>
    </message>
    <message>
        <source>The kernel&apos;s horizon is not used here: the near plane cuts the bounding sphere, the object is too small in the picture, all of it is in view and it has few triangles, or the test is switched off.</source>
        <translation>여기서는 커널의 지평선을 쓰지 않습니다: 근평면이 경계구를 자르거나, 물체가 그림에서 너무 작거나, 물체 전체가 보이고 삼각형이 적거나, 검사가 꺼져 있습니다.</translation>
    </message>
    <message>
        <source>Horizon not used: at the near plane, too far away, or of few triangles</source>
        <translation>지평선 사용 안 함: 근평면에 걸리거나, 너무 멀거나, 삼각형이 적습니다</translation>
    </message>
    <message>
        <source>Of the drawn cells, left out one by one: %1</source>
        <translation>그린 셀에서 하나씩 뺀 삼각형: %1</translation>
    </message>
    <message>
        <source>where a band begins that is drawn, by sector</source>
        <translation>그리는 띠가 시작되는 곳, 부채꼴별</translation>
    </message>
    <message>
        <source>where a band begins that is hidden, by sector</source>
        <translation>가려진 띠가 시작되는 곳, 부채꼴별</translation>
    </message>
    <message>
        <source>the largest S: from the sight ray through O to a triangle&apos;s centroid</source>
        <translation>가장 큰 S: O를 지나는 시선에서 삼각형의 무게중심까지</translation>
    </message>
    <message>
        <source>S of a band that is drawn, at its own triangle</source>
        <translation>그리는 띠의 S, 그 삼각형의 자리에</translation>
    </message>
    <message>
        <source>Drawn in vain: drawn, but in no pixel of the picture from the eye. White cells: no triangle has its centroid there.</source>
        <translation>헛되이 그려짐: 그려지지만 눈에서 본 그림의 어느 픽셀에도 나타나지 않습니다. 흰 셀: 무게중심이 그곳에 있는 삼각형이 없습니다.</translation>
    </message>
    <message>
        <source>Four corner rays, from where they enter the sphere</source>
        <translation>모서리 광선 네 개, 구에 들어가는 곳부터</translation>
    </message>
    <message>
        <source>Each row but the first differs from spherical by one reading. Views are the three cases of Table 2, 36 views from 1.6 to 2.7 radii with 45 degrees, 12 random ones with 45 degrees in which one to three corner rays hit, and 12 views of the whole object.</source>
        <translation>첫 행을 뺀 각 행은 spherical과 읽는 방식 하나가 다릅니다. 시점은 표 2의 세 경우, 반지름의 1.6배에서 2.7배까지 45도의 36개, 모서리 광선이 한 개에서 세 개까지 교차하는 45도의 무작위 12개, 물체 전체가 보이는 12개입니다.</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>찾지 못함</translation>
    </message>
    <message>
        <source>such random views, of 20,000</source>
        <translation>그런 무작위 시점, 20,000개 중</translation>
    </message>
    <message>
        <source>On the object the second, fourth, … band from the eye is darker; what is wrongly culled has an outline.</source>
        <translation>물체에서 눈으로부터 두 번째, 네 번째, … 띠는 더 어둡습니다. 잘못 제거된 부분에는 윤곽선이 있습니다.</translation>
    </message>
    <message>
        <source>The index map has as many entries as triangles touch cells at 360 × 180. The paper stores R with each entry; here R is kept by cell, as its nearest and its farthest value, unless storage=entries of spherical is chosen, which table-1 builds and spherical-readings times.</source>
        <translation>색인 맵의 항목 수는 360 × 180에서 삼각형이 셀에 닿는 수입니다. 논문은 항목마다 R을 저장합니다. 여기서는 셀마다 가장 가까운 R과 가장 먼 R을 둡니다. spherical의 storage=entries를 고르면 항목마다 R을 두며, table-1이 이를 만들고 spherical-readings가 시간을 잽니다.</translation>
    </message>
    <message>
        <source>the same, enlarged</source>
        <translation>같은 것을 확대</translation>
    </message>
    <message>
        <source>Here a cell has its nearest and farthest R. With storage=entries of spherical, R stands with each entry of the index map, and the centroid map has R, θ, φ, as in the paper&apos;s formulas.</source>
        <translation>여기서 셀은 가장 가까운 R과 가장 먼 R을 가집니다. spherical의 storage=entries에서는 논문의 식처럼 색인 맵의 항목마다 R이 있고 무게중심 맵에 R, θ, φ가 있습니다.</translation>
    </message>
    <message>
        <source>storage=entries: MB</source>
        <translation>storage=entries: MB</translation>
    </message>
    <message>
        <source>its build, ms</source>
        <translation>그 구축, ms</translation>
    </message>
    <message>
        <source>All of it goes to the pipeline</source>
        <translation>전부 파이프라인으로 보냄</translation>
    </message>
    <message>
        <source>cells along a ray</source>
        <translation>모서리 광선이 지나는 셀</translation>
    </message>
    <message>
        <source>What the maps keep of R.</source>
        <translation>맵이 R에 관해 저장하는 것.</translation>
    </message>
    <message>
        <source>of each cell its nearest and farthest surface</source>
        <translation>셀마다 가장 가까운 표면과 가장 먼 표면</translation>
    </message>
    <message>
        <source>with each entry of the index map its centroid&apos;s (Table 1)</source>
        <translation>색인 맵의 항목마다 무게중심의 R(표 1)</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that one is hit.</source>
        <translation>이 셀에서 %1번 광선은 R = %2~%3에 있습니다. R이 그에 가까운 삼각형 %4개 중 하나에 맞습니다.</translation>
    </message>
    <message>
        <source>Ray %1 is at R = %2 to %3 in this cell: of %4 triangles with an R near that none is hit.</source>
        <translation>이 셀에서 %1번 광선은 R = %2~%3에 있습니다. R이 그에 가까운 삼각형 %4개 중 아무것에도 맞지 않습니다.</translation>
    </message>
    <message>
        <source>sight ray through the middle of the sphere, seen through the object</source>
        <translation>구의 중심을 지나는 시선, 물체 너머로도 보임</translation>
    </message>
    <message>
        <source>edges of the sector and its bands, numbered from the eye; without triangles a band has no S</source>
        <translation>부채꼴과 그 띠의 경계, 번호는 눈에서부터; 삼각형이 없는 띠에는 S가 없음</translation>
    </message>
    <message>
        <source>its projection on the perpendicular axis, where S is as long</source>
        <translation>수직축에 대한 그 사영. 축 위의 S와 길이가 같음</translation>
    </message>
    <message>
        <source>wrongly culled: visible, but hidden by S: %1 of the pixels that the object covers</source>
        <translation>잘못 제거됨: 보이지만 S에 가려짐: 물체가 덮는 픽셀의 %1</translation>
    </message>
    <message>
        <source>Above, lines within the object are pale. The map shows the outermost surface in each direction from O, lit as a relief: slopes are darker than the scale.</source>
        <translation>위에서 물체 안의 선은 흐립니다. 맵은 O에서 본 각 방향의 가장 바깥 표면을 보여 줍니다. 부조처럼 빛을 받아 비탈은 눈금보다 어둡습니다.</translation>
    </message>
    <message>
        <source>of the first cell with the triangle that is hit</source>
        <translation>맞은 삼각형이 있는 첫 셀의 R</translation>
    </message>
    <message>
        <source>way from the sphere, its end: cells (θ, φ) = (%1, %2) to (%3, %4)</source>
        <translation>구에서부터의 길, 그 끝: 셀 (θ, φ) = (%1, %2)에서 (%3, %4)까지</translation>
    </message>
    <message>
        <source>Contour bands on the maps, S by sector</source>
        <translation>맵 위의 등고선 띠, 부채꼴별 S</translation>
    </message>
    <message>
        <source>Near half, and what no larger S hides: ranges of the memory access map</source>
        <translation>가까운 쪽 절반과 더 큰 S가 가리지 않는 부분: 메모리 접근 맵의 구간</translation>
    </message>
    <message>
        <source>The share of the faces that spherical considers where the case occurs, over 48 distances of 1.02 to 12 radii, three targets and twelve directions around the case&apos;s own: the least and the most; the faces of the nearest view that a search between these distances finds; and of 20,000 random views (the eye 1.05 to 4 radii away, any target within the bounding sphere, any roll) those of the case whose faces are within 5 % of the paper&apos;s. Where the nearest view is within 5 %, or a random one, the case has such views: cells go in steps, so a share between least and most may be that of no view.</source>
        <translation>그 경우가 나타나는 곳에서 spherical이 고려하는 면의 비율을, 반지름의 1.02배에서 12배까지 48개 거리, 세 목표점, 그 경우의 방향 둘레 열두 방향에 걸쳐 최소와 최대로 나타냅니다. 그 거리 사이를 탐색해 찾은 가장 가까운 시점의 면 수도 보이고, 무작위 시점 20,000개(눈은 반지름의 1.05배에서 4배 거리, 목표점은 경계구 안 어디나, 기울기는 임의) 가운데 면의 수가 논문의 5 % 안인 것을 셉니다. 가장 가까운 시점이나 무작위 시점 하나가 5 % 안이면 그런 시점이 있습니다. 칸은 계단처럼 늘어나므로 최소와 최대 사이의 비율이라도 어느 시점의 것도 아닐 수 있습니다.</translation>
    </message>
    <message>
        <source>faces of the nearest view</source>
        <translation>가장 가까운 시점의 면 수</translation>
    </message>
    <message>
        <source>walk(each object); if open, its parts</source>
        <translation>순회(물체마다), 안 정해지면 부분마다</translation>
    </message>
    <message>
        <source>Whether triangles that hold no pixel centre or face away are left out of the drawn clusters one by one (where the picture has few pixels for each; not with occlusion=hiz).</source>
        <translation>그리는 클러스터에서 픽셀 중심이 없거나 등을 돌린 삼각형을 하나씩 제외할지 여부(그림에 삼각형마다 픽셀이 적을 때; occlusion=hiz에서는 아님).</translation>
    </message>
    <message>
        <source>The state files are of different versions: the same blocks are other views.</source>
        <translation>상태 파일이 서로 다른 버전의 것입니다. 같은 블록이 다른 시점을 뜻합니다.</translation>
    </message>
    <message>
        <source>%1 is named twice: name each strategy once.</source>
        <translation>%1 전략이 두 번 나옵니다. 각 전략은 한 번만 적으십시오.</translation>
    </message>
    <message>
        <source>Name the strategy to be certified.</source>
        <translation>검증할 전략을 적으십시오.</translation>
    </message>
    <message>
        <source>Of the visible triangles, those that were not drawn</source>
        <translation>보이는 삼각형 중 그리지 않은 것</translation>
    </message>
    <message>
        <source>Of the triangles that are not visible, those that were drawn</source>
        <translation>보이지 않는 삼각형 중 그린 것</translation>
    </message>
    <message>
        <source>Of the visible objects, those of which no triangle was drawn</source>
        <translation>보이는 물체 중 삼각형을 하나도 그리지 않은 것</translation>
    </message>
    <message>
        <source>Of the objects that are not visible, those of which a triangle was drawn</source>
        <translation>보이지 않는 물체 중 삼각형을 하나라도 그린 것</translation>
    </message>
    <message>
        <source>Of the pixels in which the truth has a surface, those in which the strategy has a farther one or none</source>
        <translation>참값에 면이 있는 픽셀 중 전략에는 더 먼 면이 있거나 없는 것</translation>
    </message>
    <message>
        <source>Of all pixels, those that show a farther or a nearer surface than the truth, or none</source>
        <translation>모든 픽셀 중 참값보다 멀거나 가까운 면을 보이거나 면이 없는 것</translation>
    </message>
    <message>
        <source>How often an object begins to lose pixels, in a thousand frames along the path</source>
        <translation>경로를 따라 프레임 1,000개에서 물체가 픽셀을 잃기 시작하는 횟수</translation>
    </message>
    <message>
        <source>The most pixels that an object loses in one frame of such an event, mean over the events</source>
        <translation>그런 사건의 한 프레임에서 물체가 가장 많이 잃는 픽셀 수, 사건 평균</translation>
    </message>
    <message>
        <source>For how many frames an object loses pixels in such an event, mean over the events</source>
        <translation>그런 사건에서 물체가 픽셀을 잃는 프레임 수, 사건 평균</translation>
    </message>
    <message>
        <source>Of all pixels, those that are lost in a frame or in the one before it, and not in both</source>
        <translation>모든 픽셀 중 한 프레임과 그 앞 프레임 가운데 한쪽에서만 잃은 것</translation>
    </message>
    <message>
        <source>Difference from the shaded picture of everything, mean of all pixels and colours, of the full range</source>
        <translation>모두 그린 음영 그림과의 차이, 모든 픽셀과 색의 평균, 전체 범위 대비</translation>
    </message>
    <message>
        <source>Pixels that one of both pictures alone covers, for each pixel of the outline: about the mean distance of both outlines</source>
        <translation>두 그림 중 하나만 덮는 픽셀을 윤곽의 픽셀 수로 나눈 값: 두 윤곽의 평균 거리에 가깝습니다</translation>
    </message>
    <message>
        <source>Difference from the shaded picture of everything that 99 % of the pixels do not exceed, of the full range</source>
        <translation>모두 그린 음영 그림과의 차이 중 픽셀의 99 %가 넘지 않는 값, 전체 범위 대비</translation>
    </message>
    <message>
        <source>Pixel errors of the view that has the largest share of them</source>
        <translation>픽셀 오류의 비율이 가장 큰 시점의 값</translation>
    </message>
    <message>
        <source>These are no results of a block of cullbench certify: %1</source>
        <translation>cullbench certify의 블록 결과가 아닙니다: %1</translation>
    </message>
    <message>
        <source>not tried: at its defaults it cannot win</source>
        <translation>시도하지 않음: 기본값으로 이길 수 없음</translation>
    </message>
    <message>
        <source>A file cannot be converted in memory: %1. Close other programs.</source>
        <translation>메모리에서 파일을 변환할 수 없습니다: %1. 다른 프로그램을 닫으세요.</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2. Install or build Cullscope again.</source>
        <translation>%1 프로그램을 시작할 수 없습니다: %2. Cullscope를 다시 설치하거나 빌드하십시오.</translation>
    </message>
    <message>
        <source>numbers of windows</source>
        <translation>창의 수</translation>
    </message>
    <message>
        <source>ways of uploading vertices</source>
        <translation>정점 업로드 방식</translation>
    </message>
    <message>
        <source>%1: &quot;size&quot; must be two whole numbers from 1 to %2: width and height of the picture.</source>
        <translation>%1: &quot;size&quot;는 1에서 %2까지의 정수 두 개(그림의 너비와 높이)여야 합니다.</translation>
    </message>
    <message>
        <source>a flat box above a plane</source>
        <translation>평면 위의 납작한 상자</translation>
    </message>
    <message>
        <source>a sphere that a plane cuts, ten million from the origin</source>
        <translation>원점에서 천만 떨어진 곳에서 평면이 자르는 구</translation>
    </message>
    <message>
        <source>what is left of a file with broken faces: one triangle</source>
        <translation>깨진 면이 있는 파일에서 남은 것: 삼각형 하나</translation>
    </message>
    <message>
        <source>a triangle over the seam of a map of directions</source>
        <translation>방향 지도의 이음매에 걸친 삼각형</translation>
    </message>
    <message>
        <source>a triangle around the pole of a map of directions</source>
        <translation>방향 지도의 극을 둘러싼 삼각형</translation>
    </message>
    <message>
        <source>triangles at azimuths of 90 and 225 degrees</source>
        <translation>방위각 90도와 225도의 삼각형</translation>
    </message>
    <message>
        <source>a triangle with a corner whose azimuth rounds to a whole turn</source>
        <translation>방위각이 한 바퀴로 반올림되는 꼭짓점을 가진 삼각형</translation>
    </message>
    <message>
        <source>a triangle with a corner a hundred-millionth of a degree from the pole</source>
        <translation>꼭짓점 하나가 극에서 1억분의 1도 떨어진 삼각형</translation>
    </message>
    <message>
        <source>four hundred boxes, each of which has a name in selection mode</source>
        <translation>선택 모드에서 저마다 이름을 가진 상자 사백 개</translation>
    </message>
    <message>
        <source>%1 is no IFC file of the kind that is read: it does not begin with &quot;%2&quot;. Export it as IFC 2x3 (.ifc, not .ifcXML or .ifcZIP).</source>
        <translation>%1 파일은 읽을 수 있는 종류의 IFC 파일이 아닙니다. &quot;%2&quot;(으)로 시작하지 않습니다. IFC 2x3으로 내보내십시오(.ifcXML이나 .ifcZIP이 아닌 .ifc).</translation>
    </message>
    <message>
        <source>%1 breaks off: &quot;%2&quot; is missing at its end. Copy or export it again.</source>
        <translation>%1 파일이 중간에 끊깁니다. 끝에 &quot;%2&quot;이(가) 없습니다. 다시 복사하거나 내보내십시오.</translation>
    </message>
    <message>
        <source>%1 has the schema %2; only IFC 2x3 is read. Export the building so, or convert it to glTF.</source>
        <translation>%1 파일의 스키마는 %2입니다. IFC 2x3만 읽습니다. 건물을 IFC 2x3으로 내보내거나 glTF로 변환하십시오.</translation>
    </message>
    <message>
        <source>Shapes left out of kinds that are not read: %1 (%2).</source>
        <translation>읽지 않는 종류여서 제외한 형상: %1개(%2).</translation>
    </message>
    <message>
        <source>Elements whose openings are not all cut, because of their shape: %1 (the first is #%2).</source>
        <translation>형상 때문에 개구부를 모두 잘라내지 못한 요소: %1개(첫 번째는 #%2).</translation>
    </message>
    <message>
        <source>Other warnings of the reader: %1 (the first: %2).</source>
        <translation>판독기의 다른 경고: %1개(첫 번째: %2).</translation>
    </message>
    <message>
        <source>Converting</source>
        <translation>변환 중</translation>
    </message>
    <message>
        <source>%1 cannot be read: it makes the reader of IFC files (Assimp) crash. Export it again, or convert it to glTF.</source>
        <translation>%1 파일을 읽을 수 없습니다. 이 파일은 IFC 판독기(Assimp)를 비정상 종료시킵니다. 다시 내보내거나 glTF로 변환하십시오.</translation>
    </message>
    <message>
        <source>%1 cannot be read as IFC: %2. IFC 2x3 is read; export the building so, or convert it to glTF.</source>
        <translation>%1 파일을 IFC로 읽을 수 없습니다: %2. IFC 2x3을 읽습니다. 건물을 IFC 2x3으로 내보내거나 glTF로 변환하십시오.</translation>
    </message>
    <message>
        <source>Speed, same sides</source>
        <translation>속도(같은 면)</translation>
    </message>
    <message>
        <source>Speed, everything</source>
        <translation>속도(전부)</translation>
    </message>
    <message>
        <source>Speed, front faces</source>
        <translation>속도(앞면)</translation>
    </message>
    <message>
        <source>Lengths in %1 are taken for metres: only units of the SI are converted.</source>
        <translation>%1 단위의 길이를 미터로 봅니다. SI 단위만 변환됩니다.</translation>
    </message>
    <message>
        <source>It lost nothing in %1 views.</source>
        <translation>시점 %1개에서 잃은 것이 없습니다.</translation>
    </message>
    <message>
        <source>%1 has no report %2: list them with cullbench store %1 list.</source>
        <translation>%1에는 보고서 %2이(가) 없습니다: cullbench store %1 list로 목록을 보십시오.</translation>
    </message>
    <message>
        <source>%1 lost nothing in %2 views.</source>
        <translation>%1은(는) 시점 %2개에서 잃은 것이 없습니다.</translation>
    </message>
    <message>
        <source>0 of %1</source>
        <translation>%1 중 0</translation>
    </message>
    <message>
        <source>%1 decides by a file: choose one as its parameter %2. Until then every triangle is drawn.</source>
        <translation>%1은(는) 파일에 따라 결정합니다: 매개변수 %2에서 파일을 고르십시오. 그때까지는 모든 삼각형을 그립니다.</translation>
    </message>
    <message>
        <source>%1 is no result file of cullbench measure, race or certify, and no result store. Those of sweeps and experiments have no frames: measure them with --store. Of what a store exported, add that store.</source>
        <translation>%1은(는) cullbench measure, race, certify의 결과 파일도 결과 저장소도 아닙니다. 스윕과 실험의 결과에는 프레임이 없습니다: --store로 측정하십시오. 저장소가 내보낸 것은 그 저장소를 더하십시오.</translation>
    </message>
    <message>
        <source>Nothing of the scene is seen in any of these pictures: what is drawn cannot be judged by them. Give cameras that see it, or larger pictures.</source>
        <translation>이 그림들 어디에서도 장면이 보이지 않습니다: 무엇을 그리는지 이것으로 판정할 수 없습니다. 장면이 보이는 카메라나 더 큰 그림을 주십시오.</translation>
    </message>
    <message>
        <source>A closed mesh of two boxes that cross, one of which is inside out</source>
        <translation>서로 교차하는 상자 두 개로 된 닫힌 메시, 그중 하나는 안팎이 뒤집혀 있음</translation>
    </message>
    <message>
        <source>back faces are seen from outside: back-face culling loses them, and does not promise otherwise</source>
        <translation>밖에서 뒷면이 보임. 뒷면 제거는 이를 잃고, 잃지 않는다고 보장하지도 않음</translation>
    </message>
    <message>
        <source>a closed mesh of two boxes that cross, one of which is inside out</source>
        <translation>서로 교차하는 상자 두 개로 된 닫힌 메시, 그중 하나는 안팎이 뒤집혀 있음</translation>
    </message>
    <message>
        <source>%1 draws exactly the visible triangles, which are found beforehand: what any culling could gain at most. How much of that a method gains is its share of the headroom.</source>
        <translation>%1은(는) 보이는 삼각형만 정확히 그리며, 이들은 미리 찾아 둡니다. 어떤 컬링이든 얻을 수 있는 최대입니다. 방법이 그중 얼마를 얻는지가 여유 중 비율입니다.</translation>
    </message>
    <message>
        <source>How many objects of which nothing is known are tested before groups are, those that look largest: what they hide is left out by groups.</source>
        <translation>알려진 것이 없는 물체 가운데 가장 커 보이는 것을 몇 개까지 그룹보다 먼저 검사하는지입니다. 이들이 가리는 것은 그룹 단위로 제외됩니다.</translation>
    </message>
    <message>
        <source>0 as promised, not judged</source>
        <translation>약속으로는 0, 판정하지 않음</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AboutDialog</name>
    <message>
        <source>About Cullscope</source>
        <translation>Cullscope 정보</translation>
    </message>
    <message>
        <source>Shows what each culling strategy draws, how fast, and what it loses, measured against what is truly visible.</source>
        <translation>컬링 전략마다 무엇을 얼마나 빨리 그리고 무엇을 잃는지, 실제로 보이는 것을 기준으로 재어 보여 줍니다.</translation>
    </message>
    <message>
        <source>Qt %1
OpenGL %2
%3</source>
        <comment>versions, then the OpenGL renderer</comment>
        <translation>Qt %1
OpenGL %2
%3</translation>
    </message>
    <message>
        <source>Cullscope&apos;s own sources are under the MIT licence.</source>
        <translation>Cullscope 자체의 소스는 MIT 라이선스를 따릅니다.</translation>
    </message>
    <message>
        <source>It uses Qt under the LGPL version 3, linked dynamically: you may replace Qt by a version of your own.</source>
        <translation>Qt는 LGPL 버전 3에 따라 동적으로 연결됩니다: Qt를 다른 버전으로 바꿀 수 있습니다.</translation>
    </message>
    <message>
        <source>Also: OpenMesh and libepoxy, GLM, meshoptimizer, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json and fmt, each under its own free licence.</source>
        <translation>그 밖에 OpenMesh, libepoxy, GLM, meshoptimizer, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json, fmt를 각각의 자유 라이선스에 따라 사용합니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AdviseDialog</name>
    <message>
        <source>&amp;Advise</source>
        <translation>조언(&amp;A)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>취소(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Show it in the active view</source>
        <translation>활성 뷰에 표시(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>내보내기(&amp;E)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>닫기(&amp;L)</translation>
    </message>
    <message>
        <source>Advice: which strategy suits this scene</source>
        <translation>조언: 이 장면에 알맞은 전략</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>카메라 경로</translation>
    </message>
    <message>
        <source>A built-in camera path, or a file</source>
        <translation>내장 카메라 경로 또는 파일</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>그림의 크기</translation>
    </message>
    <message>
        <source>nothing may be missed</source>
        <translation>아무것도 놓치면 안 됨</translation>
    </message>
    <message>
        <source>may miss: </source>
        <translation>놓쳐도 됨: </translation>
    </message>
    <message>
        <source> per million</source>
        <translation> / 백만</translation>
    </message>
    <message>
        <source>How many of a million covered pixels may be missed</source>
        <translation>덮인 백만 픽셀 중 놓쳐도 되는 개수</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Promise</source>
        <translation>보장</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Build time</source>
        <translation>구축 시간</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>자료구조</translation>
    </message>
    <message>
        <source>How it came out</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Strategies by their speed</source>
        <translation>속도 순 전략</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행</translation>
    </message>
    <message>
        <source>Advice as JSON…</source>
        <translation>조언을 JSON으로…</translation>
    </message>
    <message>
        <source>Points as CSV…</source>
        <translation>점을 CSV로…</translation>
    </message>
    <message>
        <source>Plot as SVG…</source>
        <translation>그래프를 SVG로…</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>그래프를 PDF로…</translation>
    </message>
    <message>
        <source>Strategies are being tried on this scene; those that cannot win leave the race early…</source>
        <translation>이 장면에서 전략을 시험하는 중입니다. 이길 수 없는 것은 일찍 경주에서 빠집니다…</translation>
    </message>
    <message>
        <source>Each strategy that can serve this scene is measured over a camera path, and what cannot win is left out early. The answer says which one suits, what it would lose, and what its structure costs.</source>
        <translation>이 장면에 쓸 수 있는 각 전략을 카메라 경로를 따라 측정하며, 이길 수 없는 것은 일찍 제외합니다. 어느 것이 알맞은지, 무엇을 잃는지, 자료구조의 비용이 얼마인지 답합니다.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Advise.</source>
        <translation>아직 측정한 것이 없습니다. 위에서 카메라 경로를 고르고 조언을 누르십시오.</translation>
    </message>
    <message>
        <source>Headroom</source>
        <translation>여유</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save</source>
        <translation>어떤 컬링이든 아낄 수 있는 시간 중 아낀 비율</translation>
    </message>
    <message>
        <source>× everything</source>
        <translation>× 전부 그리기</translation>
    </message>
    <message>
        <source>Paid back, frames</source>
        <translation>회수까지의 프레임</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>뷰 수</translation>
    </message>
    <message>
        <source>How many views were timed. Of a strategy that left early, speed and frame time are the best one&apos;s, times how both compare at these views.</source>
        <translation>시간을 측정한 뷰의 수입니다. 일찍 빠진 전략의 속도와 프레임 시간은, 가장 좋은 전략의 값에 이 뷰들에서 둘을 비교한 비율을 곱한 값입니다.</translation>
    </message>
    <message>
        <source>Missed, ppm</source>
        <translation>놓침, ppm</translation>
    </message>
    <message>
        <source>Missed of a million covered pixels</source>
        <translation>덮인 픽셀 백만 개 중 놓친 수</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::AnswerDialog</name>
    <message>
        <source>What was expected, and what happened</source>
        <translation>예상과 실제</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BarsPanel</name>
    <message>
        <source>There is no scene: nothing was counted yet.</source>
        <translation>장면이 없습니다. 아직 센 것이 없습니다.</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>전략의 판정을 읽는 중…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BarsPlot</name>
    <message>
        <source>Counts</source>
        <translation>개수</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::BudgetBar</name>
    <message>
        <source>Where the triangles went</source>
        <translation>삼각형의 행방</translation>
    </message>
    <message>
        <source>%1: %2 triangles, %3 %</source>
        <extracomment>A state of triangles, how many, and their share of all.</extracomment>
        <translation>%1: 삼각형 %2개, %3 %</translation>
    </message>
    <message>
        <source>Not known yet.</source>
        <translation>아직 모릅니다.</translation>
    </message>
    <message>
        <source>The view changed since: being counted anew.</source>
        <translation>그 뒤 뷰가 바뀌었습니다. 다시 세는 중.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ColumnMenu</name>
    <message>
        <source>As at the first start</source>
        <translation>처음 시작할 때처럼</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ComparisonDialog</name>
    <message>
        <source>Compare two experiments</source>
        <translation>두 실험 비교</translation>
    </message>
    <message>
        <source>%1 · A: %2, B: %3</source>
        <comment>a scene, and the times of two experiments</comment>
        <translation>%1 · A: %2, B: %3</translation>
    </message>
    <message>
        <source>A and B were measured one after the other: what else the machine did then is not in the intervals.</source>
        <translation>A와 B는 차례로 따로 측정되었습니다. 그때 컴퓨터가 하던 다른 일의 영향은 구간에 들어 있지 않습니다.</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>A, ms</source>
        <translation>A, ms</translation>
    </message>
    <message>
        <source>B, ms</source>
        <translation>B, ms</translation>
    </message>
    <message>
        <source>× of B to A</source>
        <translation>A 대비 B ×</translation>
    </message>
    <message>
        <source>Missed by A</source>
        <translation>A가 놓친 픽셀</translation>
    </message>
    <message>
        <source>Missed by B</source>
        <translation>B가 놓친 픽셀</translation>
    </message>
    <message>
        <source>What the interval says</source>
        <translation>구간의 결론</translation>
    </message>
    <message>
        <source>of single frames there is no interval</source>
        <translation>프레임이 하나뿐이라 구간 없음</translation>
    </message>
    <message>
        <source>B is faster</source>
        <translation>B가 더 빠름</translation>
    </message>
    <message>
        <source>B is slower</source>
        <translation>B가 더 느림</translation>
    </message>
    <message>
        <source>no difference that it tells</source>
        <translation>차이를 알 수 없음</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Frame, ms</source>
        <translation>프레임, ms</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Conclusion</name>
    <message>
        <source>×%1 (95 %: %2 to %3)</source>
        <comment>a ratio of times and its interval</comment>
        <translation>×%1 (95 %: %2에서 %3)</translation>
    </message>
    <message>
        <source>Fastest without a lost pixel: %1, %2 against drawing everything with the same sides.</source>
        <translation>픽셀을 잃지 않고 가장 빠른 전략: %1, 같은 면을 모두 그릴 때에 비해 %2.</translation>
    </message>
    <message>
        <source>No strategy that loses no pixel is surely faster than drawing everything with the same sides; the best one is %1 with %2.</source>
        <translation>픽셀을 잃지 않는 전략 가운데 같은 면을 모두 그리는 것보다 확실히 빠른 것은 없습니다. 가장 나은 것은 %1, %2입니다.</translation>
    </message>
    <message>
        <source>Faster, with losses: %1, %2; it loses %3 of a million pixels, most of them at pose %4.</source>
        <translation>더 빠르지만 손실이 있음: %1, %2. 백만 픽셀 중 %3개를 잃고, 자세 %4에서 가장 많습니다.</translation>
    </message>
    <message>
        <source>%1 promises to lose nothing and lost %2 of a million pixels: the promise is broken.</source>
        <translation>%1은(는) 아무것도 잃지 않는다고 약속하지만 백만 픽셀 중 %2개를 잃었습니다. 약속이 깨졌습니다.</translation>
    </message>
    <message>
        <source>Losses were not measured of every strategy.</source>
        <translation>모든 전략의 손실을 측정하지는 않았습니다.</translation>
    </message>
    <message>
        <source>Only baselines were measured: there is nothing to compare.</source>
        <translation>비교 기준만 측정했으므로 비교할 것이 없습니다.</translation>
    </message>
    <message>
        <source>A software OpenGL drew: on a graphics card drawing takes less, and culling the same.</source>
        <translation>소프트웨어 OpenGL로 그렸습니다. 그래픽 카드에서는 그리기가 더 빠르고 컬링 시간은 같습니다.</translation>
    </message>
    <message>
        <source>The measurement was stopped early: poses are missing.</source>
        <translation>측정을 일찍 멈추었으므로 빠진 자세가 있습니다.</translation>
    </message>
    <message>
        <source>Drawing everything is best here: not even exactly the visible triangles, known beforehand, are surely faster.</source>
        <translation>여기서는 모두 그리는 것이 가장 좋습니다. 보이는 삼각형만 미리 알고 그려도 확실히 더 빠르지 않습니다.</translation>
    </message>
    <message>
        <source>Any culling could gain at most %1 here: so much faster are exactly the visible triangles.</source>
        <translation>여기서 컬링이 얻을 수 있는 최대는 %1입니다. 보이는 삼각형만 그릴 때의 속도입니다.</translation>
    </message>
    <message>
        <source>%1 saves %2 % of the time that can be saved.</source>
        <comment>a strategy</comment>
        <translation>%1 전략은 줄일 수 있는 시간의 %2 %를 줄입니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::CurvePlot</name>
    <message>
        <source>This frame has nothing to show here.</source>
        <translation>이 프레임에는 여기에 보여 줄 것이 없습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::DocumentCommands</name>
    <message>
        <source>Meshes (%1)</source>
        <translation>메시 (%1)</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>세션</translation>
    </message>
    <message>
        <source>Pictures that Cullscope took</source>
        <translation>Cullscope가 찍은 그림</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>모든 파일</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>열기</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>세션 저장</translation>
    </message>
    <message>
        <source>Go to camera %1</source>
        <translation>%1번 카메라로 이동</translation>
    </message>
    <message>
        <source>Keep as camera %1</source>
        <translation>%1번 카메라로 보관</translation>
    </message>
    <message>
        <source>Models, sessions and pictures</source>
        <translation>모델, 세션, 그림</translation>
    </message>
    <message>
        <source>Name a camera</source>
        <translation>카메라 이름 짓기</translation>
    </message>
    <message>
        <source>Go to camera %1: %2</source>
        <comment>its number, its name</comment>
        <translation>카메라 %1로 가기: %2</translation>
    </message>
    <message>
        <source>Camera %1…</source>
        <translation>카메라 %1…</translation>
    </message>
    <message>
        <source>Name of camera %1</source>
        <translation>카메라 %1의 이름</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::EmptyState</name>
    <message>
        <source>Opening the scene…</source>
        <translation>장면을 여는 중…</translation>
    </message>
    <message>
        <source>Open a mesh or generate a scene</source>
        <translation>메시를 열거나 장면을 생성하세요</translation>
    </message>
    <message>
        <source>The window can be used meanwhile.</source>
        <translation>그동안에도 창을 쓸 수 있습니다.</translation>
    </message>
    <message>
        <source>Drop a file here (%1), or start from a built-in scene.</source>
        <translation>파일(%1)을 여기에 끌어다 놓거나 내장 장면으로 시작하세요.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>파일 열기…</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>생성</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ExperimentBar</name>
    <message>
        <source>recorded path</source>
        <translation>녹화한 경로</translation>
    </message>
    <message>
        <source>Open a path file…</source>
        <translation>경로 파일 열기…</translation>
    </message>
    <message>
        <source>Open a camera path</source>
        <translation>카메라 경로 열기</translation>
    </message>
    <message>
        <source>Camera paths (*.json)</source>
        <translation>카메라 경로 (*.json)</translation>
    </message>
    <message>
        <source>as the view: %1 × %2</source>
        <translation>뷰와 같이: %1 × %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>시작</translation>
    </message>
    <message>
        <source>Open a scene first</source>
        <translation>먼저 장면을 여십시오</translation>
    </message>
    <message>
        <source>Camera path</source>
        <translation>카메라 경로</translation>
    </message>
    <message>
        <source>Number of poses</source>
        <translation>자세의 수</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>그림의 크기</translation>
    </message>
    <message>
        <source>Repetitions of each frame</source>
        <translation>각 프레임의 반복 횟수</translation>
    </message>
    <message>
        <source>repeat until steady</source>
        <translation>안정될 때까지 반복</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>실험 진행</translation>
    </message>
    <message>
        <source>poses: </source>
        <translation>자세: </translation>
    </message>
    <message>
        <source>repetitions: </source>
        <translation>반복: </translation>
    </message>
    <message>
        <source>Measures strategies at several values of a parameter and joins their points in the Pareto plot</source>
        <translation>매개변수의 여러 값에서 전략을 측정하고 파레토 그래프에서 그 점들을 잇습니다</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>매개변수 훑기</translation>
    </message>
    <message>
        <source>All of these</source>
        <comment>sweeps over parameters</comment>
        <translation>아래 전부</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FiguresDialog</name>
    <message>
        <source>&amp;Save</source>
        <translation>저장(&amp;S)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>닫기(&amp;L)</translation>
    </message>
    <message>
        <source>Figures of Han &amp; Hong 2008</source>
        <translation>Han &amp; Hong 2008의 그림</translation>
    </message>
    <message>
        <source>Figure %1: %2</source>
        <translation>그림 %1: %2</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>the paper&apos;s bunny</source>
        <translation>논문의 토끼</translation>
    </message>
    <message>
        <source>the open scene</source>
        <translation>열린 장면</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>case %1</source>
        <translation>경우 %1</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>경우</translation>
    </message>
    <message>
        <source>view </source>
        <translation>시점 </translation>
    </message>
    <message>
        <source>View of the case</source>
        <translation>경우의 시점</translation>
    </message>
    <message>
        <source>The figure</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation>그리는 중…</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>그림 저장</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FlowChartPanel</name>
    <message>
        <source>This strategy has no flow chart.</source>
        <translation>이 전략에는 흐름도가 없습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FlowChartPlot</name>
    <message>
        <source>Flow chart</source>
        <translation>흐름도</translation>
    </message>
    <message>
        <source>%1: the step in hand</source>
        <translation>%1: 지금 단계</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::GenerateDialog</name>
    <message>
        <source>Generate a scene: %1</source>
        <translation>장면 생성: %1</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>생성</translation>
    </message>
    <message>
        <source>objects: about %1; triangles: as the mesh has; memory beside the mesh: about %2 MB</source>
        <translation>물체: 약 %1개, 삼각형: 메시에 따름, 메시 외 메모리: 약 %2 MB</translation>
    </message>
    <message>
        <source>triangles: about %1; objects: about %2; memory: about %3 MB</source>
        <translation>삼각형: 약 %1개, 물체: 약 %2개, 메모리: 약 %3 MB</translation>
    </message>
    <message>
        <source>The scene will have: %1.</source>
        <comment>sizes</comment>
        <translation>장면의 크기: %1.</translation>
    </message>
    <message>
        <source>Generate it</source>
        <translation>생성하기</translation>
    </message>
    <message>
        <source>So large a scene takes time and memory. Above five million triangles nothing is measured unasked.</source>
        <translation>이렇게 큰 장면에는 시간과 메모리가 듭니다. 삼각형 오백만 개를 넘으면 요청하지 않는 한 아무것도 측정하지 않습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>도움말</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ 이전</translation>
    </message>
    <message>
        <source>First page</source>
        <translation>첫 페이지</translation>
    </message>
    <message>
        <source>Search the help</source>
        <translation>도움말 검색</translation>
    </message>
    <message>
        <source>Contents of the help</source>
        <translation>도움말 차례</translation>
    </message>
    <message>
        <source>No section has all these words.</source>
        <translation>이 단어를 모두 담은 절이 없습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HistoryModel</name>
    <message>
        <source>%1 · %2 ppm missed</source>
        <comment>a ratio of times, missed pixels of a million</comment>
        <translation>%1 · 놓침 %2 ppm</translation>
    </message>
    <message>
        <source>%1, %2
%3</source>
        <comment>scene, time, path and size</comment>
        <translation>%1, %2
%3</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>number of a measurement, scene and time</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::HistoryPanel</name>
    <message>
        <source>Filter by scene, strategy or date</source>
        <translation>장면, 전략, 날짜로 거르기</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>비교</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>The chosen experiments, or all that the filter leaves, as JSON or CSV</source>
        <translation>고른 실험, 또는 걸러진 모든 실험을 JSON이나 CSV로</translation>
    </message>
    <message>
        <source>Experiments beside each other</source>
        <translation>나란히 놓인 실험</translation>
    </message>
    <message>
        <source>How many times as fast the later one is, with intervals</source>
        <translation>나중 실험이 몇 배 빠른지, 구간과 함께</translation>
    </message>
    <message>
        <source>Choose two experiments by their headings, the second one with Ctrl</source>
        <translation>머리글로 두 실험을 고르십시오. 둘째는 Ctrl을 누른 채</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::KeysDialog</name>
    <message>
        <source>Mouse and keys</source>
        <translation>마우스와 키</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>왼쪽 버튼 끌기</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>휠</translation>
    </message>
    <message>
        <source>zoom to the pointer</source>
        <translation>포인터 쪽으로 확대·축소</translation>
    </message>
    <message>
        <source>Middle drag, or Shift + left drag</source>
        <translation>가운데 버튼 끌기 또는 Shift + 왼쪽 버튼 끌기</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>옆으로 이동</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>두 번 클릭</translation>
    </message>
    <message>
        <source>set the centre of rotation</source>
        <translation>회전 중심 정하기</translation>
    </message>
    <message>
        <source>Right drag</source>
        <translation>오른쪽 버튼 끌기</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>둘러보기</translation>
    </message>
    <message>
        <source>W A S D, Q E</source>
        <translation>W A S D, Q E</translation>
    </message>
    <message>
        <source>fly forward, left, back, right, down, up (Shift: faster)</source>
        <translation>앞, 왼쪽, 뒤, 오른쪽, 아래, 위로 날기(Shift: 빠르게)</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + 휠</translation>
    </message>
    <message>
        <source>near plane</source>
        <translation>가까운 절단면</translation>
    </message>
    <message>
        <source>Shift + wheel</source>
        <translation>Shift + 휠</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>시야각</translation>
    </message>
    <message>
        <source>Right click, or the menu key</source>
        <translation>오른쪽 클릭 또는 메뉴 키</translation>
    </message>
    <message>
        <source>menu of the view</source>
        <translation>뷰 메뉴</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>화살표 키</translation>
    </message>
    <message>
        <source>turn; with Shift: pan</source>
        <translation>돌리기, Shift와 함께: 옆으로 이동</translation>
    </message>
    <message>
        <source>+ and −</source>
        <translation>+ 와 −</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>확대·축소</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>back to the first view</source>
        <translation>처음 시점으로</translation>
    </message>
    <message>
        <source>. (full stop)</source>
        <translation>. (마침표)</translation>
    </message>
    <message>
        <source>show the whole scene</source>
        <translation>장면 전체 보기</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>next view or panel</source>
        <translation>다음 뷰나 패널</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>마우스</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>클릭</translation>
    </message>
    <message>
        <source>select triangle and object; on an axis&apos; end: look from there</source>
        <translation>삼각형과 물체 선택, 축 끝에서는 그 방향에서 보기</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>Alt + 1 … 4</source>
        <translation>Alt + 1 … 4</translation>
    </message>
    <message>
        <source>go to a kept camera; with Shift: keep this one</source>
        <translation>보관한 카메라로 이동, Shift와 함께: 지금 카메라 보관</translation>
    </message>
    <message>
        <source>Ctrl + K</source>
        <translation>Ctrl + K</translation>
    </message>
    <message>
        <source>add this pose to the path</source>
        <translation>이 자세를 경로에 추가</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>스페이스</translation>
    </message>
    <message>
        <source>play the path, or pause</source>
        <translation>경로 재생 또는 일시 정지</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>그림</translation>
    </message>
    <message>
        <source>freeze culling and fly on</source>
        <translation>컬링을 고정하고 계속 이동</translation>
    </message>
    <message>
        <source>colours by verdict</source>
        <translation>판정별 색</translation>
    </message>
    <message>
        <source>wipe between truth and strategy</source>
        <translation>참값과 전략을 나란히 비교</translation>
    </message>
    <message>
        <source>missed and added pixels</source>
        <translation>놓친 픽셀과 더해진 픽셀</translation>
    </message>
    <message>
        <source>next loss</source>
        <translation>다음 손실</translation>
    </message>
    <message>
        <source>loupe</source>
        <translation>돋보기</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>축</translation>
    </message>
    <message>
        <source>Window and files</source>
        <translation>창과 파일</translation>
    </message>
    <message>
        <source>number of views</source>
        <translation>뷰 개수</translation>
    </message>
    <message>
        <source>Ctrl + O, Ctrl + S</source>
        <translation>Ctrl + O, Ctrl + S</translation>
    </message>
    <message>
        <source>open; save the session</source>
        <translation>열기, 세션 저장</translation>
    </message>
    <message>
        <source>Ctrl + Z, Ctrl + Shift + Z</source>
        <translation>Ctrl + Z, Ctrl + Shift + Z</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>실행 취소, 다시 실행</translation>
    </message>
    <message>
        <source>screenshot; with Ctrl: without overlays; with Ctrl + Shift: ask</source>
        <translation>스크린샷, Ctrl: 덧그림 없이, Ctrl + Shift: 설정 묻기</translation>
    </message>
    <message>
        <source>F1, H</source>
        <translation>F1, H</translation>
    </message>
    <message>
        <source>help; this page</source>
        <translation>도움말, 이 쪽</translation>
    </message>
    <message>
        <source>step through the frame; Page Up and Page Down step</source>
        <translation>프레임을 단계별로 보기; Page Up과 Page Down으로 이동</translation>
    </message>
    <message>
        <source>question first: name what you expect, then reveal</source>
        <translation>먼저 질문: 예상을 지정한 뒤 공개</translation>
    </message>
    <message>
        <source>Ctrl + left drag</source>
        <translation>Ctrl + 왼쪽 버튼 끌기</translation>
    </message>
    <message>
        <source>in an open question: name all within the rectangle</source>
        <translation>열린 질문에서: 사각형 안의 모든 것을 지정</translation>
    </message>
    <message>
        <source>turn about what is under the pointer, or the centre of rotation</source>
        <translation>포인터 아래의 것 또는 회전 중심을 축으로 돌리기</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ 와 ]</translation>
    </message>
    <message>
        <source>fly slower, faster; the speed follows what is ahead</source>
        <translation>더 느리게, 더 빠르게 날기; 속도는 앞에 있는 것까지의 거리를 따름</translation>
    </message>
    <message>
        <source>Alt + ← and →</source>
        <translation>Alt + ←, →</translation>
    </message>
    <message>
        <source>one pose of the path back, on</source>
        <translation>경로의 이전, 다음 자세</translation>
    </message>
    <message>
        <source>watch from outside, in another view</source>
        <translation>다른 뷰에서 밖에서 관찰</translation>
    </message>
    <message>
        <source>Ctrl + 1, 2, 4, 6, 8</source>
        <translation>Ctrl + 1, 2, 4, 6, 8</translation>
    </message>
    <message>
        <source>lecture: R shows figures, P points, B blanks, Esc leaves</source>
        <translation>강의: R 수치, P 포인터, B 가리기, Esc 나가기</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up, Page Down</translation>
    </message>
    <message>
        <source>in a lesson: step back, step on</source>
        <translation>수업에서: 앞 단계, 다음 단계</translation>
    </message>
    <message>
        <source>parallel view, or perspective</source>
        <translation>평행 투영 또는 원근 투영</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LectureWindow</name>
    <message>
        <source>%1 – %2</source>
        <comment>strategy, scene</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>Speed: %1</source>
        <translation>속도: %1</translation>
    </message>
    <message>
        <source>Submitted: %1</source>
        <translation>제출: %1</translation>
    </message>
    <message>
        <source>Missed: %1</source>
        <translation>놓침: %1</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ 이전</translation>
    </message>
    <message>
        <source>Next ▶</source>
        <translation>다음 ▶</translation>
    </message>
    <message>
        <source>Lecture – Cullscope</source>
        <translation>강의 – Cullscope</translation>
    </message>
    <message>
        <source>Software OpenGL</source>
        <translation>소프트웨어 OpenGL</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>%2단계 중 %1</translation>
    </message>
    <message>
        <source>How fast, and what is lost? (R)</source>
        <translation>얼마나 빠르고, 무엇을 잃었나? (R)</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LegendPanel</name>
    <message>
        <source>Next: open a mesh file, or generate a scene.</source>
        <translation>다음: 메시 파일을 열거나 장면을 생성하세요.</translation>
    </message>
    <message>
        <source>Next: drag in a picture to turn the scene.</source>
        <translation>다음: 그림 안에서 끌어 장면을 돌려 보세요.</translation>
    </message>
    <message>
        <source>Next: turn the wheel over the scene to zoom in until part of it lies outside the picture.</source>
        <translation>다음: 장면 위에서 휠을 돌려, 일부가 그림 밖으로 나갈 때까지 확대해 보세요.</translation>
    </message>
    <message>
        <source>Next: press H to see all keys, or open a model of your own.</source>
        <translation>다음: H를 눌러 모든 키를 보거나 직접 만든 모델을 열어 보세요.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>promise, its meaning</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Next: drag in view %1 and watch in view %2 what is left out.</source>
        <translation>다음: 뷰 %1에서 끌면서, 무엇이 빠지는지 뷰 %2에서 보세요.</translation>
    </message>
    <message>
        <source>Next: click on something in a picture to see why it was drawn or left out.</source>
        <translation>다음: 그림에서 무언가를 클릭해 왜 그려졌는지 또는 빠졌는지 보세요.</translation>
    </message>
    <message>
        <source>What the colours mean</source>
        <translation>색의 뜻</translation>
    </message>
    <message>
        <source>%1: %2 triangles in the active view</source>
        <comment>a state of triangles</comment>
        <translation>%1: 활성 뷰에서 삼각형 %2개</translation>
    </message>
    <message>
        <source>Next: choose another strategy in the view&apos;s menu and compare the figures over the pictures.</source>
        <translation>다음: 뷰의 메뉴에서 다른 전략을 고르고 그림 위의 수치를 비교해 보세요.</translation>
    </message>
    <message>
        <source>Over each picture: speed, same sides drawn · triangles submitted · pixels missed</source>
        <translation>각 그림 위: 속도(같은 면) · 제출한 삼각형 · 놓친 픽셀</translation>
    </message>
    <message>
        <source>Next: begin with %1lesson 1%2, or drag in a picture to turn the scene.</source>
        <comment>a link in the text</comment>
        <translation>다음: %1수업 1%2로 시작하거나, 그림을 끌어 장면을 돌려 보십시오.</translation>
    </message>
    <message>
        <source>Triangles of view %1:</source>
        <translation>뷰 %1의 삼각형:</translation>
    </message>
    <message>
        <source>drawn, visible or not</source>
        <translation>그려짐, 보이는지는 모름</translation>
    </message>
    <message>
        <source>These views draw other sides, so their × have other baselines.</source>
        <translation>이 뷰들은 서로 다른 쪽의 면을 그려 ×의 기준이 다릅니다.</translation>
    </message>
    <message>
        <source>A frame takes: %1</source>
        <translation>한 프레임의 시간: %1</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LegendStrip</name>
    <message>
        <source>missed pixels</source>
        <translation>놓친 픽셀</translation>
    </message>
    <message>
        <source>pixels that differ</source>
        <translation>다른 픽셀</translation>
    </message>
    <message>
        <source>within snapping</source>
        <translation>맞춤 오차 안</translation>
    </message>
    <message>
        <source>nearer than the truth</source>
        <translation>참값보다 가까움</translation>
    </message>
    <message>
        <source>in hand</source>
        <translation>지금 다루는 것</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LessonBar</name>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>%2단계 중 %1</translation>
    </message>
    <message>
        <source>One step back (Page Up)</source>
        <translation>한 단계 뒤로 (Page Up)</translation>
    </message>
    <message>
        <source>One step on (Page Down)</source>
        <translation>한 단계 다음으로 (Page Down)</translation>
    </message>
    <message>
        <source>Leave the lesson: what is shown stays</source>
        <translation>수업을 나갑니다. 보이는 것은 그대로 있습니다</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LessonCommands</name>
    <message>
        <source>Open a lesson</source>
        <translation>수업 열기</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>수업</translation>
    </message>
    <message>
        <source>Add as step</source>
        <translation>단계로 추가</translation>
    </message>
    <message>
        <source>What is said at this step, in one sentence:</source>
        <translation>이 단계에서 할 말, 한 문장으로:</translation>
    </message>
    <message>
        <source>The lesson to which the step is added</source>
        <translation>단계를 추가할 수업</translation>
    </message>
    <message>
        <source>Save a handout of the lesson</source>
        <translation>수업 유인물 저장</translation>
    </message>
    <message>
        <source>Handouts</source>
        <translation>유인물</translation>
    </message>
    <message>
        <source>The steps are shown one after the other…</source>
        <translation>단계를 차례로 보여 주는 중…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ListingModel</name>
    <message>
        <source>the current line</source>
        <translation>현재 줄</translation>
    </message>
    <message>
        <source>decided about the picked triangle</source>
        <translation>선택한 삼각형을 판정함</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>줄</translation>
    </message>
    <message>
        <source>How many decisions fell at the line</source>
        <translation>이 줄에서 내린 판정의 수</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>판정</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ListingPanel</name>
    <message>
        <source>There is no scene: nothing was decided yet.</source>
        <translation>장면이 없습니다. 아직 판정한 것이 없습니다.</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>전략의 판정을 읽는 중…</translation>
    </message>
    <message>
        <source>%1, triangle %2: no decision about it fell at a line.</source>
        <comment>name of an object</comment>
        <translation>%1, 삼각형 %2: 이 줄들에서 내린 판정이 없습니다.</translation>
    </message>
    <message>
        <source>%1, triangle %2: what became of it was decided at line %3.</source>
        <comment>name of an object</comment>
        <translation>%1, 삼각형 %2: %3번 줄에서 판정되었습니다.</translation>
    </message>
    <message>
        <source>Lines of the strategy</source>
        <translation>전략의 줄</translation>
    </message>
    <message>
        <source>Decisions up to this step that fell at these lines: %1. The last one fell at line %2.</source>
        <translation>이 단계까지 이 행들에서 내린 결정: %1개. 마지막 결정은 %2행입니다.</translation>
    </message>
    <message>
        <source>No decision has fallen yet. Step on with Page Down.</source>
        <translation>아직 내려진 결정이 없습니다. Page Down으로 앞으로 가십시오.</translation>
    </message>
    <message>
        <source>Decisions of this frame that fell at these lines: %1.</source>
        <translation>이 줄들에서 내린 이 프레임의 판정: %1.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LoadingStrip</name>
    <message>
        <source>Opening %1</source>
        <translation>%1 여는 중</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>opening what, stage</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Stop opening and keep the present scene</source>
        <translation>여는 것을 멈추고 지금 장면을 유지합니다</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>여는 진행률</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LossModel</name>
    <message>
        <source>Object</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Pixels lost</source>
        <translation>잃은 픽셀</translation>
    </message>
    <message>
        <source>Share</source>
        <comment>of all lost pixels</comment>
        <translation>비율</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::LossPanel</name>
    <message>
        <source>Nothing of the scene is in this view: there is nothing to lose.</source>
        <translation>이 뷰에는 장면이 보이지 않으므로 잃을 것이 없습니다.</translation>
    </message>
    <message>
        <source>0 of %1 covered pixels lost in this view. One view cannot show a loss rarer than about 3 in %1 (&lt; %2 %).</source>
        <translation>이 뷰에서 덮인 픽셀 %1개 중 0개를 잃었습니다. 뷰 하나로는 약 %1개 중 3개(%2 %)보다 드문 손실을 알 수 없습니다.</translation>
    </message>
    <message>
        <source>There is no scene.</source>
        <translation>장면이 없습니다.</translation>
    </message>
    <message>
        <source>The view changed: what it lost is being counted…</source>
        <translation>뷰가 바뀌었습니다. 잃은 픽셀을 세는 중…</translation>
    </message>
    <message>
        <source>The scene is large: what the view lost is counted when you ask for it.</source>
        <translation>장면이 큽니다. 잃은 픽셀은 요청할 때 셉니다.</translation>
    </message>
    <message>
        <source>Objects that lost pixels</source>
        <translation>픽셀을 잃은 물체</translation>
    </message>
    <message>
        <source>Count now</source>
        <translation>지금 세기</translation>
    </message>
    <message>
        <source>%1 of %2 covered pixels lost in this view (%3 %). Holes: %4, pixels of the largest: %5. N shows the next one.</source>
        <comment>numbers of pixels</comment>
        <translation>이 뷰에서 덮인 픽셀 %2개 중 %1개를 잃음(%3 %). 구멍: %4, 가장 큰 것의 픽셀: %5. N은 다음 구멍을 보여 줍니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MainWindow</name>
    <message>
        <source>%1 – Cullscope</source>
        <translation>%1 – Cullscope</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>도구 모음</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>수치</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Software OpenGL</source>
        <translation>소프트웨어 OpenGL</translation>
    </message>
    <message>
        <source>The processor draws: times are not those of a graphics card.</source>
        <translation>프로세서가 그립니다. 시간은 그래픽 카드의 것이 아닙니다.</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>내부</translation>
    </message>
    <message>
        <source>Inside: what the strategy decided, and why</source>
        <translation>내부: 전략이 무엇을 왜 결정했는지</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapPanel</name>
    <message>
        <source>Strategies that look up what is visible by direction show their map here.</source>
        <translation>방향으로 보이는 것을 찾는 전략은 여기에 맵을 보여 줍니다.</translation>
    </message>
    <message>
        <source>&amp;Colours of the map:</source>
        <translation>맵의 색(&amp;C):</translation>
    </message>
    <message>
        <source>This strategy has no %1.</source>
        <translation>이 전략에는 %1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>Up to this step there is no %1.</source>
        <translation>이 단계까지는 %1이(가) 없습니다.</translation>
    </message>
    <message>
        <source>This frame has no %1.</source>
        <translation>이 프레임에는 %1이(가) 없습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapWidget</name>
    <message>
        <source>The arrow keys go through the cells, with Shift ten at a time; Enter picks a triangle of the cell.</source>
        <translation>화살표 키로 셀을 옮기고, Shift와 함께 누르면 열 셀씩 옮깁니다. Enter는 셀의 삼각형을 고릅니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MapWords</name>
    <message>
        <source>owns no triangle</source>
        <translation>속한 삼각형 없음</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>그려짐</translation>
    </message>
    <message>
        <source>picked</source>
        <translation>고른 것</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>이 알림 닫기</translation>
    </message>
    <message>
        <source>All of it…</source>
        <translation>전체 보기…</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>메시지</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MetricsModel</name>
    <message>
        <source>Frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>Frames per second</source>
        <translation>초당 프레임</translation>
    </message>
    <message>
        <source>Culling</source>
        <translation>컬링</translation>
    </message>
    <message>
        <source>Submitted triangles</source>
        <translation>제출한 삼각형</translation>
    </message>
    <message>
        <source>Visible triangles</source>
        <translation>보이는 삼각형</translation>
    </message>
    <message>
        <source>Missed pixels</source>
        <translation>놓친 픽셀</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>가장 큰 구멍</translation>
    </message>
    <message>
        <source>Covered pixels</source>
        <translation>덮인 픽셀</translation>
    </message>
    <message>
        <source>Culling and drawing into the view&apos;s own picture until OpenGL has finished; the window itself is not counted</source>
        <translation>컬링하고 뷰 자체의 그림에 그려 OpenGL이 끝날 때까지의 시간(창에 표시하는 시간은 제외)</translation>
    </message>
    <message>
        <source>1 / (cull + draw)</source>
        <translation>1 / (컬링 + 그리기)</translation>
    </message>
    <message>
        <source>Time in which the strategy decides what to draw</source>
        <translation>전략이 무엇을 그릴지 정하는 데 걸린 시간</translation>
    </message>
    <message>
        <source>Triangles that truly show in at least one pixel</source>
        <translation>적어도 한 픽셀에서 실제로 보이는 삼각형</translation>
    </message>
    <message>
        <source>Submitted triangles that show in no pixel</source>
        <translation>제출했지만 어느 픽셀에도 보이지 않는 삼각형</translation>
    </message>
    <message>
        <source>Pixels of the largest connected group of missed pixels</source>
        <translation>놓친 픽셀이 이어진 가장 큰 무리의 픽셀 수</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface</source>
        <translation>참값에 면이 있는 픽셀</translation>
    </message>
    <message>
        <source>Submitted in vain</source>
        <translation>헛되이 제출</translation>
    </message>
    <message>
        <source>Triangles of the scene of which anything is drawn, each counted once</source>
        <translation>일부라도 그린 장면의 삼각형. 각각 한 번만 셉니다</translation>
    </message>
    <message>
        <source>– within snapping</source>
        <translation>– 맞춤 오차 안의 것</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface and this picture a farther one or none; without those within snapping</source>
        <translation>참값에는 면이 있고 이 그림에는 더 먼 면이 있거나 없는 픽셀. 맞춤 오차 안의 픽셀은 빼고 셉니다</translation>
    </message>
    <message>
        <source>Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself</source>
        <translation>래스터가 꼭짓점을 1/256픽셀에 맞추기 때문에만 다른 픽셀이며 손실이 아닙니다. 참값이 전략과 다른 면을 그리거나, 전략이 면이나 그림을 직접 만들 때 셉니다</translation>
    </message>
    <message>
        <source>Speed, same sides drawn</source>
        <translation>속도, 같은 면을 그릴 때</translation>
    </message>
    <message>
        <source>Frame time of the baseline that draws the same sides divided by this strategy&apos;s, measured in turns at the same camera</source>
        <translation>같은 면을 그리는 기준선의 프레임 시간을 이 전략의 것으로 나눈 값, 같은 카메라에서 번갈아 측정</translation>
    </message>
    <message>
        <source>– 95 % interval</source>
        <translation>– 95 % 구간</translation>
    </message>
    <message>
        <source>95 % interval of the speed, by bootstrap over the repeated frames of this measurement. Another start of the program can differ by more</source>
        <translation>속도의 95 % 구간. 이 측정에서 반복한 프레임의 부트스트랩으로 구합니다. 프로그램을 다시 시작하면 차이가 더 클 수 있습니다</translation>
    </message>
    <message>
        <source>Any culling, at most</source>
        <translation>컬링의 최대 이득</translation>
    </message>
    <message>
        <source>Of the headroom</source>
        <translation>여유 중 비율</translation>
    </message>
    <message>
        <source>Speed of drawing exactly the visible triangles, known beforehand, against drawing all with the same sides: what any culling could gain here at most</source>
        <translation>보이는 삼각형만 미리 알고 정확히 그릴 때의 속도를 같은 면을 모두 그릴 때와 비교한 값입니다. 여기서 어떤 컬링이든 얻을 수 있는 최대입니다</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save, each against the baseline that draws the same sides. Below 0: slower than that baseline</source>
        <translation>어떤 컬링이든 줄일 수 있는 시간 중 줄인 비율로, 각각 같은 면을 그리는 기준선과 비교합니다. 0보다 작으면 그 기준선보다 느립니다</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>없음</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MetricsPanel</name>
    <message>
        <source>Figures</source>
        <translation>수치</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>소프트웨어 OpenGL: 그래픽 카드의 시간이 아님</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ObjectModel</name>
    <message>
        <source>not shown</source>
        <translation>표시 안 함</translation>
    </message>
    <message>
        <source>verdict not known yet</source>
        <translation>판정 아직 모름</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>제출됨</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>표시함</translation>
    </message>
    <message>
        <source>Whether it is shown</source>
        <translation>표시 여부</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Diagonal of its box, scene units</source>
        <translation>경계 상자의 대각선(장면 단위)</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Outliner</name>
    <message>
        <source>Hide</source>
        <translation>숨기기</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>표시</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>이것만 표시</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>모두 표시</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>맞추기</translation>
    </message>
    <message>
        <source>Search objects</source>
        <translation>물체 검색</translation>
    </message>
    <message>
        <source>Objects of the scene</source>
        <translation>장면의 물체</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PaperTableModel</name>
    <message>
        <source>As the paper prints it</source>
        <translation>논문에 인쇄된 대로</translation>
    </message>
    <message>
        <source>Measured here</source>
        <translation>여기서 측정함</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParameterForm</name>
    <message>
        <source>This strategy has no parameters.</source>
        <translation>이 전략에는 매개변수가 없습니다.</translation>
    </message>
    <message>
        <source>As on the command line: %1</source>
        <translation>명령줄에서: %1</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>파일 없음</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>파일 고르기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParetoPlot</name>
    <message>
        <source>Speed against loss</source>
        <translation>속도와 손실</translation>
    </message>
    <message>
        <source>The missed pixels were not measured, so there is no loss to show.</source>
        <translation>놓친 픽셀을 측정하지 않아 보여 줄 손실이 없습니다.</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <extracomment>Two figures, as the axes of a plot.</extracomment>
        <translation>%1, %2별</translation>
    </message>
    <message>
        <source>No strategy has both of these figures.</source>
        <translation>이 두 지표를 모두 가진 전략이 없습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a figure and its value</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1. Enter shows this strategy in the active view.</source>
        <translation>%1. Enter를 누르면 활성 뷰에 이 전략을 표시합니다.</translation>
    </message>
    <message>
        <source>A click shows it in the active view.</source>
        <translation>클릭하면 활성 뷰에 표시합니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathBar</name>
    <message>
        <source>● recording, poses: %1</source>
        <translation>● 녹화 중, 자세: %1</translation>
    </message>
    <message>
        <source>%1 is being made…</source>
        <comment>a camera path</comment>
        <translation>%1 만드는 중…</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>일시 정지 (Space)</translation>
    </message>
    <message>
        <source>Play from here (Space)</source>
        <translation>여기서 재생 (Space)</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>녹화 끝내기</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
    <message>
        <source>Leave the path (Esc)</source>
        <translation>경로 떠나기 (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a pose, number of poses</comment>
        <translation>%2 중 %1</translation>
    </message>
    <message>
        <source>One pose back</source>
        <translation>이전 자세</translation>
    </message>
    <message>
        <source>One pose back (Alt+Left)</source>
        <translation>이전 자세 (Alt+Left)</translation>
    </message>
    <message>
        <source>One pose on</source>
        <translation>다음 자세</translation>
    </message>
    <message>
        <source>One pose on (Alt+Right)</source>
        <translation>다음 자세 (Alt+Right)</translation>
    </message>
    <message>
        <source>Begin here</source>
        <translation>여기서 시작</translation>
    </message>
    <message>
        <source>Leave out the poses before this one</source>
        <translation>이 자세 앞의 자세들을 뺍니다</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>여기서 끝</translation>
    </message>
    <message>
        <source>Leave out the poses after this one</source>
        <translation>이 자세 뒤의 자세들을 뺍니다</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>부드럽게</translation>
    </message>
    <message>
        <source>Take the jerks of the hand out: each pose becomes the mean of itself and its neighbours</source>
        <translation>손 떨림을 없앱니다: 각 자세는 자신과 이웃의 평균이 됩니다</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>저장…</translation>
    </message>
    <message>
        <source>Save the path as a file</source>
        <translation>경로를 파일로 저장</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Name of the path</source>
        <translation>경로의 이름</translation>
    </message>
    <message>
        <source>name of the path</source>
        <translation>경로의 이름</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathCommands</name>
    <message>
        <source>Save the path</source>
        <translation>경로 저장</translation>
    </message>
    <message>
        <source>Camera paths</source>
        <translation>카메라 경로</translation>
    </message>
    <message>
        <source>Open a path</source>
        <translation>경로 열기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PathPlot</name>
    <message>
        <source>Along the path</source>
        <translation>경로를 따라</translation>
    </message>
    <message>
        <source>%1: %2 a frame on average</source>
        <translation>%1: 프레임 평균 %2</translation>
    </message>
    <message>
        <source>Frame time in ms, by pose</source>
        <translation>자세별 프레임 시간 (ms)</translation>
    </message>
    <message>
        <source>Missed pixels, by pose</source>
        <translation>자세별 놓친 픽셀</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PictureMenu</name>
    <message>
        <source>Copy</source>
        <translation>복사</translation>
    </message>
    <message>
        <source>Save picture as…</source>
        <translation>그림을 다른 이름으로 저장…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlacedPanels</name>
    <message>
        <source>Inside</source>
        <translation>내부</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>수치</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>범례</translation>
    </message>
    <message>
        <source>Map of directions</source>
        <translation>방향 맵</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlaneLegend</name>
    <message>
        <source>no single plane</source>
        <comment>rejected a box</comment>
        <translation>한 평면이 아님</translation>
    </message>
    <message>
        <source>kept</source>
        <comment>a box</comment>
        <translation>유지</translation>
    </message>
    <message>
        <source>Boxes by the plane that rejected them, in objects:</source>
        <translation>제외한 평면별 상자(물체 수):</translation>
    </message>
    <message>
        <source>%1: %2 objects</source>
        <comment>what became of a box</comment>
        <translation>%1: 물체 %2개</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlaneTable</name>
    <message>
        <source>Plane</source>
        <translation>평면</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>거리</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>한계</translation>
    </message>
    <message>
        <source>Outside | inside</source>
        <translation>바깥 | 안</translation>
    </message>
    <message>
        <source>The distance in multiples of the bound, logarithmically; outside begins at the dashed line.</source>
        <translation>한계의 배수로 나타낸 거리(로그 눈금). 점선부터가 바깥입니다.</translation>
    </message>
    <message>
        <source>Plane tests</source>
        <translation>평면 검사</translation>
    </message>
    <message>
        <source>The strategy did not test this plane for this object; it is worked out here.</source>
        <translation>전략은 이 물체에 대해 이 평면을 검사하지 않았습니다. 여기서 계산한 값입니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PlotWidget</name>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Start.</source>
        <translation>아직 측정한 것이 없습니다. 위에서 카메라 경로를 고르고 시작을 누르십시오.</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>측정하는 중…</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PosePlot</name>
    <message>
        <source>Pose %1</source>
        <translation>자세 %1</translation>
    </message>
    <message>
        <source>Frame: %1</source>
        <translation>프레임: %1</translation>
    </message>
    <message>
        <source>Missed: %1 pixels, %2 per million</source>
        <translation>놓침: %1픽셀, 백만분의 %2</translation>
    </message>
    <message>
        <source>Missed: not measured</source>
        <translation>놓침: 측정하지 않음</translation>
    </message>
    <message>
        <source>%1, poses: %2. The arrow keys go through them, Enter flies there.</source>
        <translation>%1, 자세: %2. 화살표 키로 하나씩 보고 Enter로 그곳에 갑니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PoseStrip</name>
    <message>
        <source>Time and loss by pose</source>
        <translation>자세별 시간과 손실</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>프레임</translation>
    </message>
    <message>
        <source>missed %1</source>
        <comment>a loss in parts per million</comment>
        <translation>놓침 %1</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PredictionModel</name>
    <message>
        <source>triangle %1</source>
        <translation>삼각형 %1</translation>
    </message>
    <message>
        <source>vanishes</source>
        <translation>사라짐</translation>
    </message>
    <message>
        <source>is drawn</source>
        <translation>그려짐</translation>
    </message>
    <message>
        <source>✓ right</source>
        <translation>✓ 맞음</translation>
    </message>
    <message>
        <source>✗ wrong</source>
        <translation>✗ 틀림</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>예상</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>실제</translation>
    </message>
    <message>
        <source>Right or wrong</source>
        <translation>맞음/틀림</translation>
    </message>
    <message>
        <source>Right: %1 of %2</source>
        <translation>맞음: %1 / %2</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>조각</translation>
    </message>
    <message>
        <source>in %1</source>
        <comment>a plane that divides space, in which a polygon lies</comment>
        <translation>%1 안</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::PresenterPage</name>
    <message>
        <source>%1 · %2 since the beginning</source>
        <comment>time of day, duration</comment>
        <translation>%1 · 시작한 지 %2</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>지금</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>다음</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a step of a lesson, number of steps</comment>
        <translation>%2단계 중 %1</translation>
    </message>
    <message>
        <source>The lecture shows the views. Page Down goes on, R shows the figures, B blanks the screen, P points.</source>
        <translation>강의 화면에 뷰가 나옵니다. Page Down은 다음, R은 수치, B는 화면 가리기, P는 포인터입니다.</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>마지막 단계입니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::QuestionBar</name>
    <message>
        <source>Click what you expect; a second click takes it back. Named: %1</source>
        <translation>예상하는 것을 클릭하십시오. 다시 클릭하면 취소됩니다. 지정: %1</translation>
    </message>
    <message>
        <source>In which order is it drawn?</source>
        <translation>어떤 순서로 그려집니까?</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>질문</translation>
    </message>
    <message>
        <source>Reveal</source>
        <translation>공개</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>질문 취소</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy has no leaves that could be named. Choose another strategy, other parameters, or another question.</source>
        <translation>활성 뷰의 전략에는 지정할 잎이 없습니다. 다른 전략, 다른 매개변수 또는 다른 질문을 고르십시오.</translation>
    </message>
    <message>
        <source>In which leaf does %1 lie? Then click the next part. Named: %2</source>
        <translation>%1은(는) 어느 잎에 있습니까? 그런 다음 다음 조각을 클릭하십시오. 지정: %2</translation>
    </message>
    <message>
        <source>In which leaf does it lie?</source>
        <translation>어느 잎에 있습니까?</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>잎</translation>
    </message>
    <message>
        <source>Click what you expect, in a view or in the tree, or drag over it with Ctrl; again takes it back. Named: %1</source>
        <translation>예상하는 것을 뷰나 트리에서 클릭하거나 Ctrl을 누른 채 끌어 둘러싸십시오. 다시 하면 취소됩니다. 지정: %1</translation>
    </message>
    <message>
        <source>Click a part, then choose the leaf in which it lies, here or in the tree. Named: %1</source>
        <translation>조각을 클릭한 다음 그것이 있는 잎을 여기나 트리에서 고르십시오. 지정: %1</translation>
    </message>
    <message>
        <source>Which objects vanish?</source>
        <translation>어느 물체가 사라집니까?</translation>
    </message>
    <message>
        <source>Which triangles vanish?</source>
        <translation>어느 삼각형이 사라집니까?</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy has %1 leaves here: more than %2 are not named. Choose a smaller scene or other parameters.</source>
        <translation>활성 뷰의 전략에는 여기에 잎이 %1개 있습니다. %2개를 넘으면 이름을 붙이지 않습니다. 더 작은 장면이나 다른 매개변수를 고르십시오.</translation>
    </message>
    <message>
        <source>Nothing was predicted yet: first click what you expect.</source>
        <translation>아직 예측한 것이 없습니다. 먼저 예상하는 것을 클릭하십시오.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::QuestionTree</name>
    <message>
        <source>Node %1</source>
        <comment>of a strategy&apos;s tree</comment>
        <translation>노드 %1</translation>
    </message>
    <message>
        <source>A click on a row answers, too.</source>
        <translation>행을 클릭해도 답이 됩니다.</translation>
    </message>
    <message>
        <source>Tree to answer by</source>
        <translation>답을 고르는 트리</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ReportsDialog</name>
    <message>
        <source>Certificate</source>
        <translation>인증서</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>조언</translation>
    </message>
    <message>
        <source>Worst view</source>
        <translation>최악의 시점</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>극단 사례 모음</translation>
    </message>
    <message>
        <source>Judgement</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>내보내기…</translation>
    </message>
    <message>
        <source>Kept reports</source>
        <translation>보관된 보고서</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>번호</translation>
    </message>
    <message>
        <source>When</source>
        <translation>때</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>종류</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>장면</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>What the report says</source>
        <translation>보고서의 내용</translation>
    </message>
    <message>
        <source>What Advice, Worst view and Stability find is kept here, beside the experiments of the statistics&apos; history.</source>
        <translation>조언, 최악의 시점, 안정성이 찾아낸 것이 통계의 기록에 있는 실험과 나란히 여기에 보관됩니다.</translation>
    </message>
    <message>
        <source>The chosen report as JSON</source>
        <translation>고른 보고서를 JSON으로</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ReproduceDialog</name>
    <message>
        <source>&amp;Start</source>
        <translation>시작(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>취소(&amp;C)</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>내보내기(&amp;X)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>닫기(&amp;L)</translation>
    </message>
    <message>
        <source>Reproduce a paper&apos;s table</source>
        <translation>논문의 표 재현</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>The paper&apos;s numbers beside ours</source>
        <translation>논문의 수치와 우리의 수치</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행</translation>
    </message>
    <message>
        <source>stopped early: what was measured until then</source>
        <translation>일찍 멈춤: 그때까지 측정한 것</translation>
    </message>
    <message>
        <source>done</source>
        <translation>완료</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
    <message>
        <source>The views show %1 at the view being measured; beside it, off the window, are measured: %2.</source>
        <translation>화면은 측정 중인 시점에서 %1을(를) 보여 주며, 창 밖에서 함께 측정하는 것: %2.</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>그래프</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ResultTableModel</name>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>fps</source>
        <translation>fps</translation>
    </message>
    <message>
        <source>fps
least – most</source>
        <translation>fps
최소 – 최대</translation>
    </message>
    <message>
        <source>Culling of
the frame</source>
        <translation>프레임 중
컬링</translation>
    </message>
    <message>
        <source>Submitted
triangles</source>
        <translation>제출한
삼각형</translation>
    </message>
    <message>
        <source>Missed
pixels</source>
        <translation>놓친
픽셀</translation>
    </message>
    <message>
        <source>Missed per
million</source>
        <translation>백만분의
놓침</translation>
    </message>
    <message>
        <source>Worst
view</source>
        <translation>가장 나쁜
시점</translation>
    </message>
    <message>
        <source>The strategy, and its parameters where they are not at their defaults</source>
        <translation>전략, 그리고 기본값이 아닌 매개변수</translation>
    </message>
    <message>
        <source>Views divided by the time of all of them; a frame is cull + draw</source>
        <translation>시점의 수를 그 시간의 합으로 나눈 값; 프레임은 컬링 + 그리기</translation>
    </message>
    <message>
        <source>In the slowest and in the fastest view</source>
        <translation>가장 느린 시점과 가장 빠른 시점에서</translation>
    </message>
    <message>
        <source>Share of the frame&apos;s time that goes into deciding what to draw</source>
        <translation>프레임 시간 중 무엇을 그릴지 정하는 데 드는 몫</translation>
    </message>
    <message>
        <source>Share of the scene&apos;s triangles given to OpenGL, mean over the views</source>
        <translation>장면의 삼각형 중 OpenGL에 넘긴 몫, 시점 평균</translation>
    </message>
    <message>
        <source>Pixels of all views in which the truth has a surface and the strategy a farther one or none</source>
        <translation>모든 시점에서 참값에는 면이 있으나 전략에는 더 먼 면이 있거나 없는 픽셀</translation>
    </message>
    <message>
        <source>Missed pixels in a million pixels in which the truth has a surface</source>
        <translation>참값에 면이 있는 픽셀 백만 개당 놓친 픽셀</translation>
    </message>
    <message>
        <source>The pose with the most missed pixels; double-click to fly there</source>
        <translation>놓친 픽셀이 가장 많은 자세; 두 번 누르면 그곳으로 갑니다</translation>
    </message>
    <message>
        <source>It lost pixels: the promise is broken.</source>
        <translation>픽셀을 잃었습니다: 보장이 깨졌습니다.</translation>
    </message>
    <message>
        <source>Speed against
%1 [95 %]</source>
        <comment>a strategy</comment>
        <translation>%1 대비
속도 [95 %]</translation>
    </message>
    <message>
        <source>Total time of %1 over the views divided by this strategy&apos;s, with its 95 % interval</source>
        <comment>a strategy</comment>
        <translation>모든 시점에서 %1의 총시간을 이 전략의 총시간으로 나눈 값과 95 % 구간</translation>
    </message>
    <message>
        <source>Within
snapping</source>
        <translation>맞춤
안의 것</translation>
    </message>
    <message>
        <source>Pixels that differ only because the raster snaps vertices to 1/256 pixel, which is no loss; counted where the truth draws other sides than the strategy, or the strategy makes surfaces or the picture itself</source>
        <translation>래스터가 꼭짓점을 1/256픽셀에 맞추기 때문에만 다른 픽셀이며 손실이 아닙니다. 참값이 전략과 다른 면을 그리거나, 전략이 면이나 그림을 직접 만들 때 셉니다</translation>
    </message>
    <message>
        <source>Speed, same
sides [95 %]</source>
        <translation>속도, 같은
면 [95 %]</translation>
    </message>
    <message>
        <source>Total time of the baseline that draws the same sides over the views divided by this strategy&apos;s, with its 95 % interval</source>
        <translation>같은 면을 그리는 기준선의 뷰 전체 시간을 이 전략의 것으로 나눈 값, 95 % 구간 포함</translation>
    </message>
    <message>
        <source>The baseline: %1</source>
        <comment>a strategy</comment>
        <translation>기준선: %1</translation>
    </message>
    <message>
        <source>Against %1: %2</source>
        <comment>a strategy; a ratio of times</comment>
        <translation>%1 대비: %2</translation>
    </message>
    <message>
        <source>Of the headroom
[95 %]</source>
        <translation>여유 중 비율
[95 %]</translation>
    </message>
    <message>
        <source>Share of the time saved that any culling could save: what is saved where exactly the visible triangles are drawn, known beforehand. Both against the baseline that draws the same sides</source>
        <translation>어떤 컬링이든 줄일 수 있는 시간 중 줄인 비율입니다. 보이는 삼각형만 미리 알고 그릴 때 줄어드는 시간이 기준이며, 둘 다 같은 면을 그리는 기준선과 비교합니다</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SceneModel</name>
    <message>
        <source>Name</source>
        <translation>이름</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>꼭짓점</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Different meshes</source>
        <translation>서로 다른 메시</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>메모리</translation>
    </message>
    <message>
        <source>– %1</source>
        <extracomment>A kind of primitive below the row of all of them, such as &quot;box&quot;.</extracomment>
        <translation>– %1</translation>
    </message>
    <message>
        <source>Primitives</source>
        <translation>기본 입체</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScenePanel</name>
    <message>
        <source>Facts of the scene</source>
        <translation>장면 정보</translation>
    </message>
    <message>
        <source>What was found in the file</source>
        <translation>파일에서 발견한 것</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>숨기기</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>표시</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>맞추기</translation>
    </message>
    <message>
        <source>Brings the selected objects into the active view</source>
        <translation>선택한 물체를 활성 뷰에 맞춥니다</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>이것만 표시</translation>
    </message>
    <message>
        <source>Hides all other objects</source>
        <translation>다른 물체를 모두 숨깁니다</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>모두 표시</translation>
    </message>
    <message>
        <source>Split…</source>
        <translation>나누기…</translation>
    </message>
    <message>
        <source>Splits the object, so that there are objects to leave out</source>
        <translation>물체를 나누어, 뺄 수 있는 물체가 생기게 합니다</translation>
    </message>
    <message>
        <source>chosen</source>
        <comment>the up axis</comment>
        <translation>선택함</translation>
    </message>
    <message>
        <source>as the scene says</source>
        <comment>the up axis</comment>
        <translation>장면에 명시됨</translation>
    </message>
    <message>
        <source>guessed from its shape</source>
        <comment>the up axis</comment>
        <translation>형태로 추정</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>위쪽 축</translation>
    </message>
    <message>
        <source>Which axis points up. The views stand anew; nothing is loaded again.</source>
        <translation>어느 축이 위를 가리키는지. 뷰를 다시 세우며, 다시 불러오지는 않습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SceneView</name>
    <message>
        <source>Truth</source>
        <translation>참값</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>letter of a view, strategy</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScreenshotDialog</name>
    <message>
        <source>Screenshot</source>
        <translation>화면 저장</translation>
    </message>
    <message>
        <source>View %1 alone</source>
        <translation>뷰 %1만</translation>
    </message>
    <message>
        <source>All views, as they are arranged</source>
        <translation>모든 뷰를 배치된 대로</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>창과 같이</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 픽셀</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>다른 크기</translation>
    </message>
    <message>
        <source>White</source>
        <translation>흰색</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>검은색</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>투명</translation>
    </message>
    <message>
        <source>&amp;Legend of the colours, with counts</source>
        <translation>개수가 있는 색 범례(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Caption</source>
        <translation>설명(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>찾아보기(&amp;B)…</translation>
    </message>
    <message>
        <source>What is saved</source>
        <translation>저장할 것</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>크기</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>너비(픽셀)</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>높이(픽셀)</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>배경</translation>
    </message>
    <message>
        <source>Text of the caption</source>
        <translation>설명 글</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>폴더</translation>
    </message>
    <message>
        <source>File name</source>
        <translation>파일 이름</translation>
    </message>
    <message>
        <source>{scene}, {strategy} and {n}, a number that no file has yet, are filled in; {n:03} has three digits. The ending chooses the format: .png, .jpg, .tif or .exr.</source>
        <translation>{scene}, {strategy}, 그리고 아직 쓰이지 않은 번호 {n}이 채워집니다. {n:03}은 세 자리입니다. 확장자가 형식을 정합니다: .png, .jpg, .tif 또는 .exr.</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>대상(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>크기(&amp;S)</translation>
    </message>
    <message>
        <source>Back&amp;ground</source>
        <translation>배경(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>폴더(&amp;F)</translation>
    </message>
    <message>
        <source>File &amp;name</source>
        <translation>파일 이름(&amp;N)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>저장</translation>
    </message>
    <message>
        <source>Depth and triangle numbers are kept for one view alone.</source>
        <translation>깊이와 삼각형 번호는 뷰 하나일 때만 저장됩니다.</translation>
    </message>
    <message>
        <source>This format keeps no transparency: the window&apos;s background takes its place.</source>
        <translation>이 형식은 투명도를 저장하지 않습니다: 창의 배경이 대신합니다.</translation>
    </message>
    <message>
        <source>Folder for screenshots</source>
        <translation>화면 저장 폴더</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names of overlays</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Will be saved as %1, %2 × %3 pixels.</source>
        <translation>%1(으)로 저장됩니다, %2 × %3 픽셀.</translation>
    </message>
    <message>
        <source>Of the strategies that have them: %1</source>
        <comment>names of overlays</comment>
        <translation>해당 전략에 있는 것: %1</translation>
    </message>
    <message>
        <source>&amp;Overlays: frustum, boxes, wipe, marks, the strategy&apos;s own</source>
        <translation>덧그림(&amp;O): 절두체, 상자, 경계선, 표시, 전략의 덧그림</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ScreenshotTaker</name>
    <message>
        <source>Saving the screenshot…</source>
        <translation>화면을 저장하는 중…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>취소</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SectionDialog</name>
    <message>
        <source>Clipping plane</source>
        <translation>절단 평면</translation>
    </message>
    <message>
        <source>&amp;Cut the pictures of all views</source>
        <translation>모든 뷰의 그림 자르기(&amp;C)</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>방향</translation>
    </message>
    <message>
        <source>the &amp;view</source>
        <translation>시선(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Place</source>
        <translation>위치(&amp;P)</translation>
    </message>
    <message>
        <source>Place of the clipping plane</source>
        <translation>절단 평면의 위치</translation>
    </message>
    <message>
        <source>Keep the &amp;other side</source>
        <translation>반대쪽 남기기(&amp;O)</translation>
    </message>
    <message>
        <source>Culling and all figures stay those of the whole scene.</source>
        <translation>컬링과 모든 수치는 전체 장면의 것 그대로입니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ShownReading</name>
    <message>
        <source>Open a scene to see what a strategy decides about it.</source>
        <translation>전략이 무엇을 결정하는지 보려면 장면을 여십시오.</translation>
    </message>
    <message>
        <source>The strategy is being prepared…</source>
        <translation>전략을 준비하고 있습니다…</translation>
    </message>
    <message>
        <source>The strategy could not be built. Choose another one, or other parameters.</source>
        <translation>전략을 만들 수 없었습니다. 다른 전략이나 다른 매개변수를 선택하십시오.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SizeDialog</name>
    <message>
        <source>Picture size</source>
        <translation>그림 크기</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>너비</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>높이</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SphereMap</name>
    <message>
        <source>Loss by direction of view</source>
        <translation>보는 방향별 손실</translation>
    </message>
    <message>
        <source>nothing missed</source>
        <translation>놓친 것 없음</translation>
    </message>
    <message>
        <source>%1 per million</source>
        <translation>백만분의 %1</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>십분의 일</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SplitDialog</name>
    <message>
        <source>Split the object</source>
        <translation>물체 나누기</translation>
    </message>
    <message>
        <source>Strategies that decide by objects have nothing to leave out in a scene of one object. What is drawn stays the same.</source>
        <translation>물체 단위로 판정하는 전략은 물체가 하나인 장면에서 뺄 것이 없습니다. 그려지는 그림은 그대로입니다.</translation>
    </message>
    <message>
        <source>Components: what hangs together becomes an object</source>
        <translation>연결 요소: 이어진 것이 한 물체가 됩니다</translation>
    </message>
    <message>
        <source>Clusters: compact pieces with at most this many triangles:</source>
        <translation>클러스터: 삼각형이 최대 이만큼인 뭉친 조각</translation>
    </message>
    <message>
        <source>Triangles a cluster</source>
        <translation>클러스터당 삼각형</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>나누기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StabilityDialog</name>
    <message>
        <source>&amp;Run all</source>
        <translation>모두 실행(&amp;R)</translation>
    </message>
    <message>
        <source>Run the &amp;chosen cases</source>
        <translation>고른 사례 실행(&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>취소(&amp;A)</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>닫기(&amp;L)</translation>
    </message>
    <message>
        <source>Stability: the battery of extreme cases</source>
        <translation>안정성: 극단 사례 모음</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>사례</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Right answer</source>
        <translation>정답</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>Cases with their right answers and what was found</source>
        <translation>사례와 정답과 결과</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행</translation>
    </message>
    <message>
        <source>Double click: open %1</source>
        <translation>두 번 클릭: %1 열기</translation>
    </message>
    <message>
        <source>right</source>
        <translation>맞음</translation>
    </message>
    <message>
        <source>WRONG</source>
        <translation>틀림</translation>
    </message>
    <message>
        <source>control</source>
        <translation>대조군</translation>
    </message>
    <message>
        <source>refuses</source>
        <translation>거절</translation>
    </message>
    <message>
        <source>Each case is a scene or a computation at the edge of what numbers hold, with its right answer. Run them, and see what every strategy does there; a double click opens the scene.</source>
        <translation>각 사례는 수가 담을 수 있는 한계에 있는 장면이나 계산이며 정답이 있습니다. 실행하면 모든 전략이 거기서 무엇을 하는지 볼 수 있고, 두 번 클릭하면 장면이 열립니다.</translation>
    </message>
    <message>
        <source>%1 of %2 cases are wrong.</source>
        <translation>사례 %2개 중 %1개가 틀렸습니다.</translation>
    </message>
    <message>
        <source>All %1 cases are right.</source>
        <translation>사례 %1개가 모두 맞습니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StatisticsDock</name>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StatisticsPanel</name>
    <message>
        <source>Open a scene: its figures appear here.</source>
        <translation>장면을 여십시오: 그 수치가 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>Nothing is measured yet. Choose a camera path above and press Start.</source>
        <translation>아직 측정한 것이 없습니다. 위에서 카메라 경로를 고르고 시작을 누르십시오.</translation>
    </message>
    <message>
        <source>The views&apos; figures appear here as soon as they are measured.</source>
        <translation>뷰들을 측정하는 대로 수치가 여기에 나타납니다.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>표</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>시간</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>자세</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>그래프</translation>
    </message>
    <message>
        <source>Pareto</source>
        <translation>파레토</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>구면</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>통계</translation>
    </message>
    <message>
        <source>at the present camera</source>
        <translation>지금 카메라에서</translation>
    </message>
    <message>
        <source>of the experiment</source>
        <translation>실험의 값</translation>
    </message>
    <message>
        <source>Which figures are shown</source>
        <translation>보이는 수치</translation>
    </message>
    <message>
        <source>Strategy whose poses are shown</source>
        <translation>자세를 보일 전략</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>결과</translation>
    </message>
    <message>
        <source>software OpenGL</source>
        <translation>소프트웨어 OpenGL</translation>
    </message>
    <message>
        <source>Software OpenGL: not the times of a graphics card</source>
        <translation>소프트웨어 OpenGL: 그래픽 카드의 시간이 아님</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>내보내기</translation>
    </message>
    <message>
        <source>Frames as CSV…</source>
        <translation>프레임을 CSV로…</translation>
    </message>
    <message>
        <source>Result as JSON…</source>
        <translation>결과를 JSON으로…</translation>
    </message>
    <message>
        <source>Plot as SVG…</source>
        <translation>그래프를 SVG로…</translation>
    </message>
    <message>
        <source>Plot as PDF…</source>
        <translation>그래프를 PDF로…</translation>
    </message>
    <message>
        <source>Report as HTML…</source>
        <translation>보고서를 HTML로…</translation>
    </message>
    <message>
        <source>Being measured…</source>
        <translation>측정하는 중…</translation>
    </message>
    <message>
        <source>%1 · %2 × %3</source>
        <extracomment>A camera path and the size of the pictures.</extracomment>
        <translation>%1 · %2 × %3</translation>
    </message>
    <message>
        <source>%1 · %2 of %3 poses</source>
        <extracomment>A camera path with the size of the picture, and how many of the path&apos;s poses were measured.</extracomment>
        <translation>%1 · 자세 %3개 중 %2개</translation>
    </message>
    <message>
        <source>History</source>
        <translation>기록</translation>
    </message>
    <message>
        <source>Report as PDF…</source>
        <translation>보고서를 PDF로…</translation>
    </message>
    <message>
        <source>Each experiment that ends appears here beside the others, also at later starts.</source>
        <translation>끝난 실험은 다른 실험과 나란히 여기에 나타나며, 다시 시작해도 남아 있습니다.</translation>
    </message>
    <message>
        <source>Race</source>
        <translation>경주</translation>
    </message>
    <message>
        <source>Each strategy against each</source>
        <translation>전략끼리의 비교</translation>
    </message>
    <message>
        <source>%1 is %2 times as fast as %3.</source>
        <comment>a strategy, a ratio, another strategy</comment>
        <translation>%1: %3의 %2배 속도입니다.</translation>
    </message>
    <message>
        <source>It takes %1 ms less a view (95 %: %2 to %3).</source>
        <translation>시점당 %1 ms 덜 걸립니다(95 %: %2 ~ %3).</translation>
    </message>
    <message>
        <source>It takes %1 ms less a view.</source>
        <translation>시점당 %1 ms 덜 걸립니다.</translation>
    </message>
    <message>
        <source>It misses %1 of a million pixels more.</source>
        <translation>백만 픽셀 중 %1개를 더 놓칩니다.</translation>
    </message>
    <message>
        <source>The interval holds 1: which one is faster is not decided.</source>
        <translation>구간에 1이 들어 있어 어느 쪽이 빠른지 정해지지 않았습니다.</translation>
    </message>
    <message>
        <source>Figure across</source>
        <translation>가로 지표</translation>
    </message>
    <message>
        <source>Figure upwards</source>
        <translation>세로 지표</translation>
    </message>
    <message>
        <source>→ %1</source>
        <translation>→ %1</translation>
    </message>
    <message>
        <source>↑ %1</source>
        <translation>↑ %1</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>열</translation>
    </message>
    <message>
        <source>Which columns the table shows</source>
        <translation>표에 보일 열</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>How many times as fast as the column&apos;s strategy the row&apos;s is, and how many milliseconds a view it takes less (−) or more (+), each with its 95 % interval. Bold: faster for certain; ≈: not decided.</source>
        <translation>행의 전략이 열의 전략보다 몇 배 빠른지, 그리고 뷰마다 몇 밀리초 덜(−) 또는 더(+) 걸리는지를 95 % 신뢰 구간과 함께 보여 줍니다. 굵게: 확실히 더 빠름, ≈: 결정되지 않음.</translation>
    </message>
    <message>
        <source>Each strategy is held against each other one as soon as an experiment has ended.</source>
        <translation>실험이 끝나면 모든 전략을 서로 견주어 보여 줍니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StepBar</name>
    <message>
        <source>%1 of %2</source>
        <comment>a step, number of steps</comment>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>place, size of the steps</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>by subject</source>
        <translation>대상별</translation>
    </message>
    <message>
        <source>by object</source>
        <translation>물체별</translation>
    </message>
    <message>
        <source>by command</source>
        <translation>명령별</translation>
    </message>
    <message>
        <source>in equal parts</source>
        <translation>균등하게</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>일시 정지</translation>
    </message>
    <message>
        <source>Play from here</source>
        <translation>여기서부터 재생</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>전략의 결정을 읽는 중…</translation>
    </message>
    <message>
        <source>Breakpoints</source>
        <translation>중단점</translation>
    </message>
    <message>
        <source>Breakpoints: %1</source>
        <translation>중단점: %1</translation>
    </message>
    <message>
        <source>Each step is one decision or command of the frame.</source>
        <translation>한 단계는 프레임의 결정이나 명령 하나입니다.</translation>
    </message>
    <message>
        <source>This frame has %1 decisions and commands: each step takes several of them.</source>
        <translation>이 프레임에는 결정과 명령이 %1개 있습니다. 한 단계가 그중 여러 개를 묶습니다.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>kind of decision, how many</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>To the start (Shift+Page Up)</source>
        <translation>처음으로 (Shift+Page Up)</translation>
    </message>
    <message>
        <source>One step back (Page Up)</source>
        <translation>한 단계 뒤로 (Page Up)</translation>
    </message>
    <message>
        <source>One step on (Page Down)</source>
        <translation>한 단계 앞으로 (Page Down)</translation>
    </message>
    <message>
        <source>To the end (Shift+Page Down)</source>
        <translation>끝으로 (Shift+Page Down)</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>단계</translation>
    </message>
    <message>
        <source>Steps a second:</source>
        <translation>초당 단계:</translation>
    </message>
    <message>
        <source>Playing stops at decisions of these kinds; Ctrl+Page Down and Ctrl+Page Up go to the next and the last one</source>
        <translation>이런 결정에서 재생이 멈춥니다. Ctrl+Page Down과 Ctrl+Page Up은 다음과 이전 중단점으로 갑니다</translation>
    </message>
    <message>
        <source>Show the whole frame again (F8)</source>
        <translation>프레임 전체를 다시 보기 (F8)</translation>
    </message>
    <message>
        <source>The method itself records this frame coarser:</source>
        <translation>방법 자체가 이 프레임을 더 성기게 기록합니다:</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::Stepper</name>
    <message>
        <source>Nothing was decided and nothing was drawn yet.</source>
        <translation>아직 아무것도 결정하거나 그리지 않았습니다.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>subject of a decision, what was found</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StrategyPanel</name>
    <message>
        <source>Strategy of view %1</source>
        <translation>뷰 %1의 전략</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StructureModel</name>
    <message>
        <source>Node %1</source>
        <comment>of a tree of boxes</comment>
        <translation>노드 %1</translation>
    </message>
    <message>
        <source>kept</source>
        <comment>a box that holds others</comment>
        <translation>유지</translation>
    </message>
    <message>
        <source>submitted</source>
        <translation>제출됨</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>물체</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>삼각형</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>판정</translation>
    </message>
    <message>
        <source>Rejected by</source>
        <translation>탈락시킨 평면</translation>
    </message>
    <message>
        <source>1 object</source>
        <comment>a group of one</comment>
        <translation>물체 1개</translation>
    </message>
    <message>
        <source>%1 objects</source>
        <comment>a group of so many</comment>
        <translation>물체 %1개</translation>
    </message>
    <message>
        <source>%1: %2 triangles</source>
        <comment>an object or a group</comment>
        <translation>%1: 삼각형 %2개</translation>
    </message>
    <message>
        <source>no single plane</source>
        <comment>has a group outside</comment>
        <translation>한 평면이 아님</translation>
    </message>
    <message>
        <source>%1: %2 objects</source>
        <comment>a group by its name</comment>
        <translation>%1: 물체 %2개</translation>
    </message>
    <message>
        <source>all %1</source>
        <comment>a box whose parts were left out for one cause</comment>
        <translation>모두 %1</translation>
    </message>
    <message>
        <source>all left out</source>
        <comment>the parts of a box</comment>
        <translation>모두 제외</translation>
    </message>
    <message>
        <source>partly kept</source>
        <comment>a box that holds others</comment>
        <translation>일부 유지</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StructurePanel</name>
    <message>
        <source>Inside the strategy</source>
        <translation>전략의 내부</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>트리</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>Losses</source>
        <translation>손실</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>코드</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>개수</translation>
    </message>
    <message>
        <source>Chart</source>
        <comment>a tab: a flow chart</comment>
        <translation>순서도</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::StructureTree</name>
    <message>
        <source>Boxes that the strategy tests</source>
        <translation>전략이 검사하는 상자</translation>
    </message>
    <message>
        <source>This strategy tests no boxes. Strategies that test bounds or descend a tree list them here, with what they decided about each.</source>
        <translation>이 전략은 상자를 검사하지 않습니다. 경계를 검사하거나 트리를 내려가는 전략은 상자마다 내린 판정을 여기에 보여 줍니다.</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::SweepWords</name>
    <message>
        <source>auto</source>
        <comment>a parameter&apos;s value that a strategy chooses</comment>
        <translation>자동</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <extracomment>A strategy and the parameter that is varied, as in &quot;spherical by rows&quot;.</extracomment>
        <translation>%1, %2별</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>what is varied, its values</comment>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::TimeBar</name>
    <message>
        <source>Time of a frame</source>
        <translation>한 프레임의 시간</translation>
    </message>
    <message>
        <source>%1 = %2 cull + %3 draw</source>
        <extracomment>A frame&apos;s time: total = culling + drawing</extracomment>
        <translation>%1 = 컬링 %2 + 그리기 %3</translation>
    </message>
    <message>
        <source>cull</source>
        <translation>컬링</translation>
    </message>
    <message>
        <source>draw</source>
        <translation>그리기</translation>
    </message>
    <message>
        <source>grey: %1 and %2</source>
        <comment>two strategies</comment>
        <translation>회색: %1과 %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::UndoRecorder</name>
    <message>
        <source>Undo</source>
        <translation>실행 취소</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>실행 취소: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>다시 실행: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>다시 실행</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::UndoStep</name>
    <message>
        <source>hidden objects</source>
        <translation>숨긴 물체</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>카메라</translation>
    </message>
    <message>
        <source>camera of view %1</source>
        <translation>뷰 %1의 카메라</translation>
    </message>
    <message>
        <source>several changes</source>
        <translation>여러 변경</translation>
    </message>
    <message>
        <source>strategy of view %1</source>
        <translation>뷰 %1의 전략</translation>
    </message>
    <message>
        <source>parameters of view %1</source>
        <translation>뷰 %1의 매개변수</translation>
    </message>
    <message>
        <source>display of view %1</source>
        <translation>뷰 %1의 표시</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewCommands</name>
    <message>
        <source>Copy the picture</source>
        <translation>그림 복사</translation>
    </message>
    <message>
        <source>Copy the picture without what lies over it</source>
        <translation>덧그림 없이 그림 복사</translation>
    </message>
    <message>
        <source>Copy the cullbench command</source>
        <translation>cullbench 명령 복사</translation>
    </message>
    <message>
        <source>Object %1</source>
        <comment>its name</comment>
        <translation>물체 %1</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>이유</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>맞추기</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>숨기기</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>이것만 표시</translation>
    </message>
    <message>
        <source>Show all hidden objects</source>
        <translation>숨긴 물체 모두 표시</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewHeader</name>
    <message>
        <source>%1: %2</source>
        <comment>strategy: promise</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>측정</translation>
    </message>
    <message>
        <source>Compare this large scene with the truth now; this may take a while</source>
        <translation>이 큰 장면을 지금 참값과 비교합니다. 시간이 걸릴 수 있습니다</translation>
    </message>
    <message>
        <source>Promise: %1, %2</source>
        <comment>word, sentence</comment>
        <translation>약속: %1, %2</translation>
    </message>
    <message>
        <source>View %1: %2, %3</source>
        <comment>letter, strategy and promise, figures</comment>
        <translation>뷰 %1: %2, %3</translation>
    </message>
    <message>
        <source>What view %1 shows, and how</source>
        <translation>%1 뷰가 보이는 것과 방식</translation>
    </message>
    <message>
        <source>watches %1</source>
        <comment>letter of a view</comment>
        <translation>%1 관찰</translation>
    </message>
    <message>
        <source>frozen</source>
        <translation>고정</translation>
    </message>
    <message>
        <source>What do you expect? The figures come with the answer.</source>
        <translation>무엇을 예상하십니까? 수치는 답과 함께 나옵니다.</translation>
    </message>
    <message>
        <source>step %1 of %2 · whole frame: %3</source>
        <translation>단계 %1 / %2 · 프레임 전체: %3</translation>
    </message>
    <message>
        <source>step %1 · %2</source>
        <comment>of a narrow view, figures</comment>
        <translation>단계 %1 · %2</translation>
    </message>
    <message>
        <source>%1 · at %2 %</source>
        <comment>size, percent</comment>
        <extracomment>Of a picture: its size in pixels, and how large the window shows it.</extracomment>
        <translation>%1 · %2 %로 표시</translation>
    </message>
    <message>
        <source>Picture and figures: %1 pixels, which fit the window: figures change with it</source>
        <translation>그림과 수치: 창에 맞춘 %1 픽셀. 수치가 창에 따라 바뀝니다</translation>
    </message>
    <message>
        <source>Picture and figures: %1 pixels, shown at %2 %; figures do not change with the window</source>
        <translation>그림과 수치: %1 픽셀, %2 %로 표시. 수치는 창에 따라 바뀌지 않습니다</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ViewPane</name>
    <message>
        <source>near plane %1</source>
        <translation>가까운 절단면 %1</translation>
    </message>
    <message>
        <source>field of view %1°</source>
        <translation>시야각 %1°</translation>
    </message>
    <message>
        <source>%1 (Home resets)</source>
        <translation>%1 (Home: 되돌리기)</translation>
    </message>
    <message>
        <source>Picture of view %1</source>
        <translation>뷰 %1의 그림</translation>
    </message>
    <message>
        <source>Arrow keys turn, plus and minus zoom, Shift with arrow keys pans, W A S D Q E fly.</source>
        <translation>화살표 키로 돌리고, 더하기와 빼기로 확대·축소하고, Shift와 화살표 키로 옆으로 움직이고, W A S D Q E로 날아다닙니다.</translation>
    </message>
    <message>
        <source>culling frozen (F)</source>
        <translation>컬링 고정 (F)</translation>
    </message>
    <message>
        <source>vertex arrays</source>
        <translation>정점 배열</translation>
    </message>
    <message>
        <source>%1 pixels differ from view %2</source>
        <translation>%2 뷰와 다른 픽셀 %1개</translation>
    </message>
    <message>
        <source>hidden objects: %1</source>
        <translation>숨긴 물체: %1</translation>
    </message>
    <message>
        <source>loss %1 of %2, pixels: %3</source>
        <translation>손실 %1/%2, 픽셀: %3</translation>
    </message>
    <message>
        <source>visible triangles in both: %1, only here: %2, only in view %3: %4</source>
        <translation>둘 다에 보이는 삼각형: %1, 여기만: %2, 뷰 %3만: %4</translation>
    </message>
    <message>
        <source>missed pixels: %1, nearer than the truth: %2</source>
        <translation>놓친 픽셀: %1, 참값보다 가까운 픽셀: %2</translation>
    </message>
    <message>
        <source>missed pixels: %1, within snapping and not lost: %2, nearer than the truth: %3</source>
        <translation>놓친 픽셀: %1, 맞춤 오차 안에 있어 놓치지 않은 픽셀: %2, 참값보다 가까운 픽셀: %3</translation>
    </message>
    <message>
        <source>difference within snapping %1 of %2, pixels: %3</source>
        <translation>맞춤 오차 안의 차이 %1/%2, 픽셀: %3</translation>
    </message>
    <message>
        <source>nothing in view: Home</source>
        <translation>보이는 것이 없음: Home</translation>
    </message>
    <message>
        <source>flying speed × %1 ([ and ])</source>
        <translation>비행 속도 × %1 ([ 와 ])</translation>
    </message>
    <message>
        <source>wireframe; figures of the filled picture</source>
        <translation>와이어프레임, 수치는 채워진 그림의 것</translation>
    </message>
    <message>
        <source>coarse while it moves: %1 of %2 triangles, by object</source>
        <translation>움직이는 동안 거칠게: 삼각형 %2개 중 %1개, 물체 단위</translation>
    </message>
    <message>
        <source>parallel, height %1</source>
        <translation>평행 투영, 높이 %1</translation>
    </message>
    <message>
        <source>cut by a plane; figures of the whole scene</source>
        <translation>평면으로 자름, 수치는 전체 장면의 것</translation>
    </message>
    <message>
        <source>coarse while it moves: %1 of %2 triangles, by object; what lies outside as boxes</source>
        <translation>움직이는 동안 거칠게: 삼각형 %2개 중 %1개, 물체 단위. 절두체 밖은 상자</translation>
    </message>
    <message>
        <source>difference %1 of %2, pixels: %3</source>
        <translation>차이 %1/%2, 픽셀: %3</translation>
    </message>
    <message>
        <source>missing up to this step, pixels: %1, nearer than the truth: %2</source>
        <translation>이 단계까지 없는 픽셀: %1, 참값보다 가까운 픽셀: %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WhyPanel</name>
    <message>
        <source>Click on something in a picture to see why it was drawn or left out.</source>
        <translation>그림에서 무언가를 클릭하면 왜 그려졌는지 또는 빠졌는지 볼 수 있습니다.</translation>
    </message>
    <message>
        <source>The picked object is hidden by you. Show it again to see why the strategy draws it or leaves it out.</source>
        <translation>선택한 물체는 직접 숨긴 것입니다. 다시 표시하면 전략이 왜 그리거나 빼는지 볼 수 있습니다.</translation>
    </message>
    <message>
        <source>Why the picked triangle was drawn or left out</source>
        <translation>선택한 삼각형이 그려졌거나 빠진 이유</translation>
    </message>
    <message>
        <source>The strategy&apos;s decisions are being read…</source>
        <translation>전략의 판정을 읽는 중…</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>number of a step, its sentence</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Whether it is visible is not known yet.</source>
        <translation>보이는지는 아직 모릅니다.</translation>
    </message>
    <message>
        <source>%1, triangle %2</source>
        <comment>name of an object</comment>
        <translation>%1, 삼각형 %2</translation>
    </message>
    <message>
        <source>It shows in the picture.</source>
        <translation>그림에 보입니다.</translation>
    </message>
    <message>
        <source>It was drawn in vain: other triangles lie before all of it, or it covers no pixel&apos;s middle.</source>
        <translation>헛되이 그려졌습니다. 다른 삼각형이 모두 가리거나, 어느 픽셀의 중심도 덮지 않습니다.</translation>
    </message>
    <message>
        <source>It was wrongly left out: the truth shows it.</source>
        <translation>잘못 제외되었습니다. 참값에는 보입니다.</translation>
    </message>
    <message>
        <source>In grey: not tested by the strategy for this object alone; worked out here from its own box.</source>
        <translation>회색: 전략이 이 물체만으로는 검사하지 않은 평면으로, 물체 자신의 상자에서 여기서 계산했습니다.</translation>
    </message>
    <message>
        <source>drawn, or decided to be drawn</source>
        <translation>그려졌거나 그리기로 결정됨</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <comment>state of a triangle, the sentence that says what decided</comment>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 from the point picked before (x %2, y %3, z %4)</source>
        <comment>a length, and its components along the axes</comment>
        <translation>앞서 고른 점에서 %1 (x %2, y %3, z %4)</translation>
    </message>
    <message>
        <source>Left out, within the raster&apos;s snapping</source>
        <translation>래스터의 맞춤 오차 안에서 빠짐</translation>
    </message>
    <message>
        <source>The truth shows it where the raster&apos;s rounding of corners to 1/256 pixel explains the difference: no pixel is lost.</source>
        <translation>참값에는 보이지만, 래스터가 꼭짓점을 1/256 픽셀로 맞추는 것으로 설명되는 차이입니다. 잃은 픽셀은 없습니다.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>two sentences</comment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WindowActions</name>
    <message>
        <source>&amp;File</source>
        <translation>파일(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>보기(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Up axis</source>
        <translation>위쪽 축(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>모양(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>언어(&amp;L) / Language</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>도움말(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Generate</source>
        <translation>생성(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>열기(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>끝내기(&amp;Q)</translation>
    </message>
    <message>
        <source>Leave the program</source>
        <translation>프로그램을 끝냅니다</translation>
    </message>
    <message>
        <source>&amp;1 view</source>
        <translation>뷰 1개(&amp;1)</translation>
    </message>
    <message>
        <source>Show one view</source>
        <translation>뷰 하나만 보기</translation>
    </message>
    <message>
        <source>&amp;2 views</source>
        <translation>뷰 2개(&amp;2)</translation>
    </message>
    <message>
        <source>Show two views beside each other</source>
        <translation>뷰 두 개를 나란히 보기</translation>
    </message>
    <message>
        <source>&amp;Home</source>
        <translation>처음 시점(&amp;H)</translation>
    </message>
    <message>
        <source>Back to the first view of the scene</source>
        <translation>장면의 처음 시점으로 돌아가기</translation>
    </message>
    <message>
        <source>&amp;Frame the scene</source>
        <translation>장면 맞춤(&amp;F)</translation>
    </message>
    <message>
        <source>Show the whole scene from the present direction</source>
        <translation>지금 방향에서 장면 전체 보기</translation>
    </message>
    <message>
        <source>&amp;y up</source>
        <translation>y축(&amp;Y)</translation>
    </message>
    <message>
        <source>The y axis points up</source>
        <translation>y축이 위쪽입니다</translation>
    </message>
    <message>
        <source>&amp;z up</source>
        <translation>z축(&amp;Z)</translation>
    </message>
    <message>
        <source>The z axis points up</source>
        <translation>z축이 위쪽입니다</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>시스템 설정(&amp;S)</translation>
    </message>
    <message>
        <source>Light or dark as the system is set</source>
        <translation>시스템 설정에 따라 밝게 또는 어둡게</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>밝게(&amp;L)</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>밝은 바탕에 어두운 글자</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>어둡게(&amp;D)</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>어두운 바탕에 밝은 글자</translation>
    </message>
    <message>
        <source>Mouse and &amp;keys</source>
        <translation>마우스와 키(&amp;K)</translation>
    </message>
    <message>
        <source>Show all mouse moves and keys</source>
        <translation>모든 마우스 조작과 키 보기</translation>
    </message>
    <message>
        <source>&amp;About Cullscope</source>
        <translation>Cullscope 정보(&amp;A)</translation>
    </message>
    <message>
        <source>Version and licences</source>
        <translation>버전과 라이선스</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>편집(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>그림(&amp;P)</translation>
    </message>
    <message>
        <source>P&amp;ath</source>
        <translation>경로(&amp;A)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>최근 파일 열기(&amp;R)</translation>
    </message>
    <message>
        <source>Open a mesh file, a session, or a picture that Cullscope took</source>
        <translation>메시 파일, 세션, 또는 Cullscope가 찍은 그림을 엽니다</translation>
    </message>
    <message>
        <source>&amp;Save the session</source>
        <translation>세션 저장(&amp;S)</translation>
    </message>
    <message>
        <source>Save scene, views, strategies and cameras as a file</source>
        <translation>장면, 뷰, 전략, 카메라를 파일로 저장합니다</translation>
    </message>
    <message>
        <source>Save the session &amp;as…</source>
        <translation>다른 이름으로 세션 저장(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>세션을 다른 이름으로 저장합니다</translation>
    </message>
    <message>
        <source>S&amp;creenshot…</source>
        <translation>화면 저장(&amp;C)…</translation>
    </message>
    <message>
        <source>Save a picture of the views: size, format, legend, background</source>
        <translation>뷰의 그림을 저장합니다: 크기, 형식, 범례, 배경</translation>
    </message>
    <message>
        <source>Screenshot a&amp;gain</source>
        <translation>화면 다시 저장(&amp;G)</translation>
    </message>
    <message>
        <source>Save a picture as the last time</source>
        <translation>지난번과 같이 그림을 저장합니다</translation>
    </message>
    <message>
        <source>Screenshot &amp;without overlays</source>
        <translation>덧그림 없이 화면 저장(&amp;W)</translation>
    </message>
    <message>
        <source>Save a picture of what was drawn and nothing over it</source>
        <translation>그려진 것만 그림으로 저장합니다</translation>
    </message>
    <message>
        <source>Camera &amp;bookmarks</source>
        <translation>카메라 책갈피(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>패널(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;4 views</source>
        <translation>뷰 4개(&amp;4)</translation>
    </message>
    <message>
        <source>Compare four views</source>
        <translation>뷰 네 개를 비교합니다</translation>
    </message>
    <message>
        <source>&amp;8 views</source>
        <translation>뷰 8개(&amp;8)</translation>
    </message>
    <message>
        <source>Compare eight views</source>
        <translation>뷰 여덟 개를 비교합니다</translation>
    </message>
    <message>
        <source>&amp;Lecture</source>
        <translation>강의(&amp;L)</translation>
    </message>
    <message>
        <source>Show the active view full screen, large enough for the back row</source>
        <translation>활성 뷰를 뒷줄에서도 보이게 전체 화면으로 표시합니다</translation>
    </message>
    <message>
        <source>&amp;Reset the layout</source>
        <translation>배치 초기화(&amp;R)</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>모든 패널을 제자리로 되돌립니다</translation>
    </message>
    <message>
        <source>&amp;Freeze culling</source>
        <translation>컬링 고정(&amp;F)</translation>
    </message>
    <message>
        <source>The culling camera stands while you fly on in the active view</source>
        <translation>활성 뷰에서 비행하는 동안 컬링 카메라는 멈춰 있습니다</translation>
    </message>
    <message>
        <source>Wipe: &amp;truth | strategy</source>
        <translation>나란히: 참값 | 전략(&amp;T)</translation>
    </message>
    <message>
        <source>Put the truth beside the strategy&apos;s picture; drag the line</source>
        <translation>전략의 그림 옆에 참값을 놓습니다. 선을 끌어 보십시오</translation>
    </message>
    <message>
        <source>&amp;Missed pixels</source>
        <translation>놓친 픽셀(&amp;M)</translation>
    </message>
    <message>
        <source>Mark the pixels that the strategy missed or added</source>
        <translation>전략이 놓치거나 더한 픽셀을 표시합니다</translation>
    </message>
    <message>
        <source>&amp;Next loss</source>
        <translation>다음 손실(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next lost pixels, largest hole first</source>
        <translation>가장 큰 구멍부터 다음 손실 픽셀로 갑니다</translation>
    </message>
    <message>
        <source>&amp;Loupe</source>
        <translation>돋보기(&amp;L)</translation>
    </message>
    <message>
        <source>Enlarge what is under the pointer</source>
        <translation>포인터 아래를 확대합니다</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>기록(&amp;R)</translation>
    </message>
    <message>
        <source>Record the camera&apos;s moves as a path</source>
        <translation>카메라의 움직임을 경로로 기록합니다</translation>
    </message>
    <message>
        <source>&amp;Add this pose</source>
        <translation>이 자세 추가(&amp;A)</translation>
    </message>
    <message>
        <source>Add the present camera to the path</source>
        <translation>현재 카메라를 경로에 추가합니다</translation>
    </message>
    <message>
        <source>&amp;Save the path…</source>
        <translation>경로 저장(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the recorded path as a file</source>
        <translation>기록한 경로를 파일로 저장합니다</translation>
    </message>
    <message>
        <source>&amp;Open a path…</source>
        <translation>경로 열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a camera path to play it</source>
        <translation>재생할 카메라 경로를 엽니다</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>재생(&amp;P)</translation>
    </message>
    <message>
        <source>Play the path, a picture of every view at every pose</source>
        <translation>자세마다 모든 뷰의 그림을 그리며 경로를 재생합니다</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>정지(&amp;T)</translation>
    </message>
    <message>
        <source>Stop recording and playing</source>
        <translation>기록과 재생을 멈춥니다</translation>
    </message>
    <message>
        <source>A&amp;xes</source>
        <translation>축(&amp;X)</translation>
    </message>
    <message>
        <source>Show the axes in a corner of each view; a click on an end looks from there</source>
        <translation>각 뷰의 구석에 축을 표시합니다. 축 끝을 클릭하면 그 방향에서 봅니다</translation>
    </message>
    <message>
        <source>What the views, panels and figures mean</source>
        <translation>뷰, 패널, 수치의 뜻</translation>
    </message>
    <message>
        <source>Repro&amp;duce a paper&apos;s table…</source>
        <translation>논문의 표 재현(&amp;D)…</translation>
    </message>
    <message>
        <source>Measure what a paper&apos;s table shows, in the paper&apos;s windows, and put its numbers beside ours</source>
        <translation>논문의 표를 논문과 같은 창에서 측정하여 수치를 나란히 놓습니다</translation>
    </message>
    <message>
        <source>Not while the view shows the model in spherical coordinates: what a camera sees has no place there</source>
        <translation>뷰가 모델을 구좌표로 표시하는 동안에는 쓸 수 없습니다. 카메라가 보는 것이 놓일 자리가 없습니다</translation>
    </message>
    <message>
        <source>S&amp;tep through</source>
        <translation>단계별로 보기(&amp;T)</translation>
    </message>
    <message>
        <source>Replay the active view&apos;s frame step by step, with what the strategy decides</source>
        <translation>활성 뷰의 프레임을 전략의 결정과 함께 단계별로 재생</translation>
    </message>
    <message>
        <source>&amp;Question first</source>
        <translation>먼저 질문(&amp;Q)</translation>
    </message>
    <message>
        <source>Hide figures and verdicts until what the audience expects was clicked, then reveal both beside each other</source>
        <translation>청중의 예상을 클릭할 때까지 수치와 판정을 숨긴 뒤 나란히 공개</translation>
    </message>
    <message>
        <source>One step on</source>
        <translation>한 단계 앞으로</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>한 단계 뒤로</translation>
    </message>
    <message>
        <source>To the first step</source>
        <translation>첫 단계로</translation>
    </message>
    <message>
        <source>To the last step</source>
        <translation>마지막 단계로</translation>
    </message>
    <message>
        <source>On to the next breakpoint</source>
        <translation>다음 중단점으로</translation>
    </message>
    <message>
        <source>Back to the last breakpoint</source>
        <translation>이전 중단점으로</translation>
    </message>
    <message>
        <source>One pose o&amp;n</source>
        <translation>다음 자세(&amp;N)</translation>
    </message>
    <message>
        <source>Show the next pose of the path, without measuring</source>
        <translation>경로의 다음 자세를 측정 없이 보여 줍니다</translation>
    </message>
    <message>
        <source>Show the pose before, without measuring</source>
        <translation>앞의 자세를 측정 없이 보여 줍니다</translation>
    </message>
    <message>
        <source>&amp;Built-in paths</source>
        <translation>내장 경로(&amp;B)</translation>
    </message>
    <message>
        <source>One pose bac&amp;k</source>
        <translation>이전 자세(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>수업(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>수업 열기(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a lesson&apos;s file</source>
        <translation>수업 파일을 엽니다</translation>
    </message>
    <message>
        <source>&amp;Add as step…</source>
        <translation>단계로 추가(&amp;A)…</translation>
    </message>
    <message>
        <source>Add what the window shows to a lesson of your own</source>
        <translation>창이 보여 주는 것을 자신의 수업에 추가합니다</translation>
    </message>
    <message>
        <source>&amp;Handout…</source>
        <translation>유인물(&amp;H)…</translation>
    </message>
    <message>
        <source>Save all steps of the lesson as a PDF or HTML file: picture, sentence and figures</source>
        <translation>수업의 모든 단계를 그림, 문장, 수치와 함께 PDF나 HTML 파일로 저장합니다</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>다음 단계</translation>
    </message>
    <message>
        <source>Go on to the lesson&apos;s next step</source>
        <translation>수업의 다음 단계로 갑니다</translation>
    </message>
    <message>
        <source>Step before</source>
        <translation>앞 단계</translation>
    </message>
    <message>
        <source>Go back to the lesson&apos;s step before</source>
        <translation>수업의 앞 단계로 돌아갑니다</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>첫 단계</translation>
    </message>
    <message>
        <source>Go to the lesson&apos;s first step</source>
        <translation>수업의 첫 단계로 갑니다</translation>
    </message>
    <message>
        <source>Last step</source>
        <translation>마지막 단계</translation>
    </message>
    <message>
        <source>Go to the lesson&apos;s last step</source>
        <translation>수업의 마지막 단계로 갑니다</translation>
    </message>
    <message>
        <source>&amp;Leave the lesson</source>
        <translation>수업 나가기(&amp;L)</translation>
    </message>
    <message>
        <source>Leave the lesson: what is shown stays</source>
        <translation>수업을 나갑니다. 보이는 것은 그대로 있습니다</translation>
    </message>
    <message>
        <source>&amp;6 views</source>
        <translation>뷰 6개(&amp;6)</translation>
    </message>
    <message>
        <source>Compare six views: three columns</source>
        <translation>뷰 여섯 개를 세 열로 비교합니다</translation>
    </message>
    <message>
        <source>&amp;Watch from outside</source>
        <translation>밖에서 관찰(&amp;W)</translation>
    </message>
    <message>
        <source>Another view shows from outside what the active view culls; again: it is linked</source>
        <translation>다른 뷰가 활성 뷰의 컬링을 밖에서 보여 줍니다. 다시 누르면 연결됩니다</translation>
    </message>
    <message>
        <source>Look &amp;from</source>
        <translation>보는 방향(&amp;F)</translation>
    </message>
    <message>
        <source>Picture si&amp;ze</source>
        <translation>그림 크기(&amp;Z)</translation>
    </message>
    <message>
        <source>Pro&amp;jection</source>
        <translation>투영(&amp;J)</translation>
    </message>
    <message>
        <source>&amp;Perspective</source>
        <translation>원근(&amp;P)</translation>
    </message>
    <message>
        <source>Lines of sight meet in the eye: what is farther is smaller</source>
        <translation>시선이 눈에서 만납니다. 멀수록 작게 보입니다</translation>
    </message>
    <message>
        <source>P&amp;arallel</source>
        <translation>평행(&amp;A)</translation>
    </message>
    <message>
        <source>Lines of sight run side by side: sizes do not depend on the distance (orthographic)</source>
        <translation>시선이 나란합니다. 크기가 거리에 따라 달라지지 않습니다(직교 투영)</translation>
    </message>
    <message>
        <source>Clippin&amp;g plane…</source>
        <translation>절단 평면(&amp;G)…</translation>
    </message>
    <message>
        <source>Cut the pictures by a plane, to look inside: a section</source>
        <translation>그림을 평면으로 잘라 안을 봅니다(단면)</translation>
    </message>
    <message>
        <source>Sta&amp;bility…</source>
        <translation>안정성(&amp;B)…</translation>
    </message>
    <message>
        <source>Run the battery of extreme cases, and open their scenes</source>
        <translation>극단 사례 모음을 실행하고 그 장면을 엽니다</translation>
    </message>
    <message>
        <source>Dra&amp;w a paper&apos;s figure…</source>
        <translation>논문의 그림 그리기(&amp;W)…</translation>
    </message>
    <message>
        <source>Draw a figure of a paper anew, and save it as a picture or as its numbers</source>
        <translation>논문의 그림을 새로 그려 그림이나 수치로 저장합니다</translation>
    </message>
    <message>
        <source>Adv&amp;ise…</source>
        <translation>조언(&amp;I)…</translation>
    </message>
    <message>
        <source>Measure which strategy suits this scene, what it would lose, and what it costs</source>
        <translation>이 장면에 알맞은 전략과 그 손실, 비용을 측정합니다</translation>
    </message>
    <message>
        <source>W&amp;orst view…</source>
        <translation>최악의 시점(&amp;O)…</translation>
    </message>
    <message>
        <source>Search for the view in which the active view&apos;s strategy loses most or gains least</source>
        <translation>활성 뷰의 전략이 가장 많이 잃거나 가장 적게 얻는 시점을 찾습니다</translation>
    </message>
    <message>
        <source>&amp;Kept reports…</source>
        <translation>보관된 보고서(&amp;K)…</translation>
    </message>
    <message>
        <source>The advice, worst views, runs of the battery and certificates of the result store</source>
        <translation>결과 저장소에 있는 조언, 최악의 시점, 극단 사례 모음의 실행, 인증서</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::WorstDialog</name>
    <message>
        <source>&amp;Search</source>
        <translation>찾기(&amp;S)</translation>
    </message>
    <message>
        <source>C&amp;ancel</source>
        <translation>취소(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Go to the worst view</source>
        <translation>최악의 시점으로 가기(&amp;G)</translation>
    </message>
    <message>
        <source>Sa&amp;ve the map…</source>
        <translation>지도 저장(&amp;V)…</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>닫기(&amp;L)</translation>
    </message>
    <message>
        <source>The worst view of a strategy</source>
        <translation>전략의 최악의 시점</translation>
    </message>
    <message>
        <source>that loses most</source>
        <translation>가장 많이 잃는 시점</translation>
    </message>
    <message>
        <source>that gains least</source>
        <translation>가장 적게 얻는 시점</translation>
    </message>
    <message>
        <source>What is sought</source>
        <translation>찾는 것</translation>
    </message>
    <message>
        <source>from around the scene</source>
        <translation>장면 둘레에서</translation>
    </message>
    <message>
        <source>from places within the scene</source>
        <translation>장면 안의 위치에서</translation>
    </message>
    <message>
        <source>Where the eye is</source>
        <translation>눈의 위치</translation>
    </message>
    <message>
        <source>views: </source>
        <translation>시점: </translation>
    </message>
    <message>
        <source>How many views are tried at most</source>
        <translation>시험할 시점의 최대 개수</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>진행</translation>
    </message>
    <message>
        <source>Views are being tried, the worst parts of the map again and again in smaller parts…</source>
        <translation>시점을 시험하는 중입니다. 지도의 최악인 부분을 더 작게 나누어 거듭 시험합니다…</translation>
    </message>
    <message>
        <source>The active view&apos;s strategy is drawn in many views, and the worst ones are searched more closely. A click on the map flies there.</source>
        <translation>활성 뷰의 전략을 많은 시점에서 그리고, 최악인 곳을 더 자세히 찾습니다. 지도를 클릭하면 그곳으로 갑니다.</translation>
    </message>
    <message>
        <source>Save the map</source>
        <translation>지도 저장</translation>
    </message>
    <message>
        <source>Pictures (*.svg *.pdf *.png)</source>
        <translation>그림 (*.svg *.pdf *.png)</translation>
    </message>
</context>
</TS>

<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ko" sourcelanguage="en">
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
        <extracomment>Line 2 of a view&apos;s header: speed against `backface`, share of the triangles submitted, missed pixels.</extracomment>
        <translation>%1 · %2 % · 놓침 %3</translation>
    </message>
    <message>
        <source>Speed: %1 fps = 1 / (cull + draw), %2 a frame, of which %3 culling</source>
        <translation>속도: %1 fps = 1 / (컬링 + 그리기), 프레임당 %2, 그중 컬링 %3</translation>
    </message>
    <message>
        <source>Submitted: %1 of %2 triangles, %3 of them visible</source>
        <translation>제출: 삼각형 %2개 중 %1개, 그중 %3개가 보임</translation>
    </message>
    <message>
        <source>Missed: %1 of %2 covered pixels, largest hole %3</source>
        <translation>놓침: 덮인 픽셀 %2개 중 %1개, 가장 큰 구멍 %3</translation>
    </message>
    <message>
        <source>Truth: item buffer of %1 × %2 pixels, %3</source>
        <translation>정답: %1 × %2 픽셀 아이템 버퍼, %3</translation>
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
        <source>Of the missed, beyond the raster&apos;s snapping to 1/256 pixel: %1</source>
        <translation>놓친 픽셀 중 래스터의 1/256픽셀 맞춤으로 설명되지 않는 것: %1</translation>
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
        <translation>이 장면에 전략 %1을(를) 준비할 수 없습니다: %2</translation>
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
        <source>%1 is compressed with xz. Unpack it first: xz -dk &quot;%1&quot;.</source>
        <translation>%1 파일은 xz로 압축되어 있습니다. 먼저 푸세요: xz -dk &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>%1 is compressed with gzip. Unpack it first: gzip -dk &quot;%1&quot;.</source>
        <translation>%1 파일은 gzip으로 압축되어 있습니다. 먼저 푸세요: gzip -dk &quot;%1&quot;.</translation>
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
        <translation>그대로 둔 비다양체 모서리(삼각형이 셋 이상): %1.</translation>
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
        <translation>%1: 물체 &quot;%2&quot;이(가) 1e-30보다 작습니다. 크기를 키우세요.</translation>
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
        <translation>면이 %1개보다 많아 중복 면과 비다양체 모서리는 찾지 않았습니다.</translation>
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
        <translation>메시 &quot;%1&quot;을(를) 삼각형 %2개로 바꿀 수 없습니다. 조각들은 %3개까지만 줄일 수 있습니다. 그 이상을 지정하세요.</translation>
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
        <source>&quot;%1&quot; is neither a camera path file nor a built-in path. Built in: orbit:N, fibonacci:N, walk:N, case-1, case-2, case-3.</source>
        <translation>&quot;%1&quot;은(는) 카메라 경로 파일도 내장 경로도 아닙니다. 내장 경로: orbit:N, fibonacci:N, walk:N, case-1, case-2, case-3.</translation>
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
        <source>a close view with a pole of the spherical map in it</source>
        <translation>구면 맵의 극이 들어 있는 가까운 시점</translation>
    </message>
    <message>
        <source>a close view of one clump of the spherical map</source>
        <translation>구면 맵의 한 덩어리를 보는 가까운 시점</translation>
    </message>
    <message>
        <source>a close view of a clump that the map&apos;s seam splits</source>
        <translation>맵의 이음매가 가르는 덩어리를 보는 가까운 시점</translation>
    </message>
    <message>
        <source>%1: %2=%3 is not a number between %4 and %5.</source>
        <translation>%1: %2=%3은(는) %4과(와) %5 사이의 수가 아닙니다.</translation>
    </message>
    <message>
        <source>%1 has no parameter &quot;%2&quot;. It has: %3.</source>
        <translation>%1에는 매개변수 &quot;%2&quot;이(가) 없습니다. 있는 것: %3.</translation>
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
        <source>mesh file, or bunny</source>
        <translation>메시 파일 또는 bunny</translation>
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
        <translation>후면 제거</translation>
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
        <source>front where every mesh is closed, else two-sided</source>
        <translation>모든 메시가 닫혀 있으면 앞면만, 아니면 양면</translation>
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
        <translation>여기에는 매개변수 &quot;%1&quot;이(가) 없습니다. 알려진 것: %2.</translation>
    </message>
    <message>
        <source>There is no strategy &quot;%1&quot;. Known: %2.</source>
        <translation>전략 &quot;%1&quot;이(가) 없습니다. 알려진 것: %2.</translation>
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
        <source>There is not enough memory to draw this view. Make the window or the scene smaller.</source>
        <translation>이 뷰를 그릴 메모리가 부족합니다. 창이나 장면을 더 작게 하세요.</translation>
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
        <source>It uses Qt under the LGPL version 3, linked dynamically: you may replace Qt by a version of your own. This program does not link Qt Charts, which is under the GPL version 3; a program that links it is under the GPL version 3 as a whole.</source>
        <translation>Qt는 LGPL 버전 3에 따라 동적으로 링크하여 사용하므로, 직접 만든 Qt로 바꿀 수 있습니다. 이 프로그램은 GPL 버전 3인 Qt Charts를 링크하지 않습니다. Qt Charts를 링크한 프로그램은 전체가 GPL 버전 3을 따르게 됩니다.</translation>
    </message>
    <message>
        <source>Also: OpenMesh and libepoxy, GLM, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json and fmt, each under its own free licence.</source>
        <translation>그 밖에 OpenMesh, libepoxy, GLM, tinyobjloader, OpenImageIO, Embree, oneTBB, OpenSSL, CLI11, nlohmann-json, fmt를 각각의 자유 라이선스에 따라 사용합니다.</translation>
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
    <name>cullscope::ui::FigureModel</name>
    <message>
        <source>Speed against backface</source>
        <translation>backface 대비 속도</translation>
    </message>
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
        <source>Drawn in vain</source>
        <translation>헛되이 그림</translation>
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
        <source>Frame time of the strategy backface divided by this strategy&apos;s, measured in turns at the same camera</source>
        <translation>같은 카메라에서 번갈아 잰 backface 전략의 프레임 시간을 이 전략의 프레임 시간으로 나눈 값</translation>
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
        <source>Triangles given to OpenGL</source>
        <translation>OpenGL에 넘긴 삼각형</translation>
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
        <source>Pixels in which the truth has a surface and this picture a farther one or none</source>
        <translation>정답에는 면이 있으나 이 그림에는 더 먼 면이 있거나 아무것도 없는 픽셀</translation>
    </message>
    <message>
        <source>Pixels of the largest connected group of missed pixels</source>
        <translation>놓친 픽셀이 이어진 가장 큰 무리의 픽셀 수</translation>
    </message>
    <message>
        <source>Pixels in which the truth has a surface</source>
        <translation>정답에 면이 있는 픽셀</translation>
    </message>
    <message>
        <source>– beyond snapping</source>
        <translation>– 맞춤을 넘는 것</translation>
    </message>
    <message>
        <source>Missed pixels that the raster&apos;s snapping of vertices to 1/256 pixel does not explain; counted where the strategy draws front faces only and the truth both sides</source>
        <translation>래스터가 꼭짓점을 1/256픽셀에 맞추는 것으로 설명되지 않는 놓친 픽셀. 전략은 앞면만, 정답은 양면을 그릴 때 셉니다</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::FigurePanel</name>
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
    <name>cullscope::ui::GenerateDialog</name>
    <message>
        <source>Generate a scene: %1</source>
        <translation>장면 생성: %1</translation>
    </message>
    <message>
        <source>Generate</source>
        <translation>생성</translation>
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
        <source>turn about the centre of rotation</source>
        <translation>회전 중심을 축으로 돌리기</translation>
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
        <source>Ctrl + 1, Ctrl + 2</source>
        <translation>Ctrl + 1, Ctrl + 2</translation>
    </message>
    <message>
        <source>one view, two views</source>
        <translation>뷰 1개, 뷰 2개</translation>
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
        <source>Ctrl + O</source>
        <translation>Ctrl + O</translation>
    </message>
    <message>
        <source>open a file</source>
        <translation>파일 열기</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>this page</source>
        <translation>이 페이지</translation>
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
        <source>Next: choose another strategy above and compare the figures over the pictures.</source>
        <translation>다음: 위에서 다른 전략을 고르고 그림 위의 수치를 비교해 보세요.</translation>
    </message>
    <message>
        <source>Next: press H to see all keys, or open a model of your own.</source>
        <translation>다음: H를 눌러 모든 키를 보거나 직접 만든 모델을 열어 보세요.</translation>
    </message>
    <message>
        <source>Over each picture: speed against backface · triangles submitted · pixels missed</source>
        <translation>그림 위: backface 대비 속도 · 제출한 삼각형 · 놓친 픽셀</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>promise, its meaning</comment>
        <translation>%1: %2</translation>
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
    <name>cullscope::ui::MainWindow</name>
    <message>
        <source>%1 – Cullscope</source>
        <translation>%1 – Cullscope</translation>
    </message>
    <message>
        <source>Strategy and figures</source>
        <translation>전략과 수치</translation>
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
        <source>Open a mesh file</source>
        <translation>메시 파일 열기</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>그림 복사</translation>
    </message>
    <message>
        <source>Copy the cullbench command</source>
        <translation>cullbench 명령 복사</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>전략</translation>
    </message>
    <message>
        <source>Figures and scene</source>
        <translation>수치와 장면</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>메시(%1)</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>모든 파일</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>이 알림 닫기</translation>
    </message>
</context>
<context>
    <name>cullscope::ui::ParameterForm</name>
    <message>
        <source>This strategy has no parameters.</source>
        <translation>이 전략에는 매개변수가 없습니다.</translation>
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
        <translation>이 큰 장면을 지금 정답과 비교합니다. 시간이 걸릴 수 있습니다</translation>
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
        <source>Open a mesh file</source>
        <translation>메시 파일 열기</translation>
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
</context>
</TS>
